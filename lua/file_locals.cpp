#include "lua/file_locals.h"

#include <algorithm>
#include <set>

namespace lsos {

namespace {

constexpr lua_Integer functions_max = 1000;
constexpr std::size_t locals_max = 100;
constexpr int tables_deep = 3;

// Adds the function at the top to the list at `list` once; pops it.
void add_function(lua_State* L, int list) {
  lua_pushvalue(L, -1);
  const bool is_known = lua_rawget(L, list) != LUA_TNIL;
  lua_pop(L, 1);
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, list));
  if (is_known || lua_iscfunction(L, -1) != 0 || count >= functions_max) return lua_pop(L, 1);
  lua_pushvalue(L, -1);
  lua_rawseti(L, list, count + 1);
  lua_pushboolean(L, 1);
  lua_rawset(L, list);
}

// Those in the table at the top, which stays.
void add_functions(lua_State* L, int list, int deep) {
  const int table = lua_gettop(L);
  for (lua_pushnil(L); lua_next(L, table) != 0;) {
    if (lua_isfunction(L, -1)) {
      add_function(L, list);
      continue;
    }
    if (lua_istable(L, -1) && deep > 1) add_functions(L, list, deep - 1);
    lua_pop(L, 1);
  }
}

// Not-a-number is what it was when it is one still.
bool are_same(lua_State* L, int a, int b) {
  if (lua_type(L, a) != lua_type(L, b)) return false;
  return lua_rawequal(L, a, b) != 0 || (lua_rawequal(L, a, a) == 0 && lua_rawequal(L, b, b) == 0);
}

}  // namespace

FileLocals::FileLocals(lua_State* L, int index) {
  index = lua_absindex(L, index);
  const int top = lua_gettop(L);
  luaL_checkstack(L, 2 * tables_deep + 10, nullptr);
  lua_newtable(L);
  const int kept = lua_gettop(L);
  lua_newtable(L);
  const int list = lua_gettop(L);
  lua_pushvalue(L, index);
  add_functions(L, list, tables_deep);
  lua_pop(L, 1);
  std::set<const void*> seen;
  for (lua_Integer k = 1; lua_rawgeti(L, list, k) != LUA_TNIL; ++k, lua_pop(L, 1)) {
    const int function = lua_gettop(L);
    for (int n = 1; const char* name = lua_getupvalue(L, function, n); ++n) {
      if (lua_isfunction(L, -1)) {
        add_function(L, list);
        continue;
      }
      const bool is_plain = lua_isnil(L, -1) || lua_isboolean(L, -1) ||
                            lua_type(L, -1) == LUA_TNUMBER || lua_type(L, -1) == LUA_TSTRING;
      const bool is_new = is_plain && seen.insert(lua_upvalueid(L, function, n)).second;
      if (!is_new || locals_.size() >= locals_max) {
        lua_pop(L, 1);
        continue;
      }
      const lua_Integer at = 2 * static_cast<lua_Integer>(locals_.size()) + 1;
      lua_rawseti(L, kept, at + 1);
      lua_pushvalue(L, function);
      lua_rawseti(L, kept, at);
      locals_.push_back({name, n, at});
    }
  }
  lua_pushvalue(L, kept);
  kept_ = luaL_ref(L, LUA_REGISTRYINDEX);
  lua_settop(L, top);
  std::ranges::sort(locals_, {},
                    [](const Local& local) { return std::pair(local.name, local.function); });
}

std::string FileLocals::restore(lua_State* L) const {
  if (locals_.empty()) return {};
  std::string changed;
  lua_rawgeti(L, LUA_REGISTRYINDEX, kept_);
  const int kept = lua_gettop(L);
  for (const Local& local : locals_) {
    lua_rawgeti(L, kept, local.function);
    lua_rawgeti(L, kept, local.function + 1);
    lua_getupvalue(L, kept + 1, local.upvalue);
    if (!are_same(L, -1, -2)) {
      if (changed.empty()) changed = local.name;
      lua_pop(L, 1);
      lua_setupvalue(L, kept + 1, local.upvalue);
    }
    lua_settop(L, kept);
  }
  lua_pop(L, 1);
  return changed;
}

}  // namespace lsos
