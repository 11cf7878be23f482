#include "lua/runtime/file_locals.h"

#include <algorithm>
#include <set>

namespace lsos {

namespace {

constexpr lua_Integer functions_max = 1000;
constexpr std::size_t locals_max = 100;
constexpr std::size_t entries_max = 1000;  // of all tables
constexpr int tables_deep = 3;

// Adds the function at the top to the list at `list`, once; pops it.
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

// Calls what() with each function and table in the table at the top, each at the top. The order is
// the same in every process: text keys by bytes, then whole numbers. Other keys have no such order
// and are skipped.
template <class What>
void for_each_part(lua_State* L, const What& what) {
  const int table = lua_gettop(L);
  std::vector<std::string> texts;
  std::vector<lua_Integer> numbers;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (!lua_isfunction(L, -1) && !lua_istable(L, -1)) continue;
    std::size_t size = 0;
    if (lua_type(L, -2) == LUA_TSTRING) {
      const char* bytes = lua_tolstring(L, -2, &size);
      texts.emplace_back(bytes, size);
    } else if (lua_isinteger(L, -2) != 0) {
      numbers.push_back(lua_tointeger(L, -2));
    }
  }
  std::ranges::sort(texts);
  std::ranges::sort(numbers);
  for (const std::string& text : texts) {
    lua_pushlstring(L, text.data(), text.size());
    lua_rawget(L, table);
    what();
    lua_settop(L, table);
  }
  for (const lua_Integer number : numbers) {
    lua_rawgeti(L, table, number);
    what();
    lua_settop(L, table);
  }
}

// Sets the metatable of the table at `index` to the one at the top, or to none for nil; pops it. A
// '__gc' that was added to the metatable since is hidden from Lua: it would run without a budget.
void set_metatable(lua_State* L, int index) {
  if (!lua_istable(L, -1)) {
    lua_setmetatable(L, index);
    return;
  }
  const int metatable = lua_gettop(L);
  const auto set_gc = [&](int value) {
    lua_pushliteral(L, "__gc");
    lua_pushvalue(L, value);
    lua_rawset(L, metatable);
  };
  lua_pushliteral(L, "__gc");
  lua_rawget(L, metatable);
  lua_pushnil(L);
  set_gc(metatable + 2);
  lua_pushvalue(L, metatable);
  lua_setmetatable(L, index);
  set_gc(metatable + 1);
  lua_settop(L, metatable - 1);
}

// Adds the functions in the table at the top, which stays, and in the tables and metatables that it
// leads to.
void add_functions(lua_State* L, int list, int deep) {
  for_each_part(L, [&] {
    if (lua_isfunction(L, -1)) {
      add_function(L, list);
    } else if (deep > 1) {
      add_functions(L, list, deep - 1);
    }
  });
  if (deep == 1 || lua_getmetatable(L, -1) == 0) return;
  add_functions(L, list, deep - 1);
  lua_pop(L, 1);
}

// Whether the table at the top is empty and protected. Libraries are such tables: their contents
// are behind them, and they cannot be written to, though functions of lib/ may have locals.
bool is_library(lua_State* L) {
  if (luaL_getmetafield(L, -1, "__metatable") == LUA_TNIL) return false;
  lua_pop(L, 1);
  lua_pushnil(L);
  if (lua_next(L, -2) == 0) return true;
  lua_pop(L, 2);
  return false;
}

// Whether two values are the same; not-a-number counts as equal to itself.
bool are_same(lua_State* L, int a, int b) {
  if (lua_type(L, a) != lua_type(L, b)) return false;
  return lua_rawequal(L, a, b) != 0 || (lua_rawequal(L, a, a) == 0 && lua_rawequal(L, b, b) == 0);
}

}  // namespace

FileLocals::FileLocals(lua_State* L, int index) {
  index = lua_absindex(L, index);
  const int top = lua_gettop(L);
  luaL_checkstack(L, 8 * tables_deep + 10, nullptr);
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
      const bool is_new = seen.insert(lua_upvalueid(L, function, n)).second;
      if (!is_new || name == std::string_view("_ENV") || locals_.size() >= locals_max) {
        lua_pop(L, 1);
        continue;
      }
      if (lua_istable(L, -1)) {
        add_functions(L, list, tables_deep);
        if (!is_library(L)) add_table(L, kept, name, tables_deep);
      }
      locals_.push_back({name, n, keep(L, kept, function)});
    }
  }
  lua_pushvalue(L, kept);
  kept_ = luaL_ref(L, LUA_REGISTRYINDEX);
  lua_settop(L, top);
  const auto by_name = [](const auto& local) -> const std::string& { return local.name; };
  std::ranges::stable_sort(locals_, {}, by_name);
  std::ranges::stable_sort(tables_, {}, by_name);
}

lua_Integer FileLocals::keep(lua_State* L, int kept, int owner) {
  const lua_Integer at = kept_count_ + 1;
  kept_count_ += 2;
  lua_rawseti(L, kept, at + 1);
  lua_pushvalue(L, owner);
  lua_rawseti(L, kept, at);
  return at;
}

void FileLocals::add_table(lua_State* L, int kept, const char* name, int deep) {
  const int table = lua_gettop(L);
  if (!seen_.insert(lua_topointer(L, table)).second) return;
  lua_newtable(L);
  const int copy = lua_gettop(L);
  std::size_t entries = 0;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (++entries + entries_ > entries_max) return lua_settop(L, table);
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, copy);
  }
  entries_ += entries;
  tables_.push_back({name, keep(L, kept, table), entries});
  if (lua_getmetatable(L, table) == 0) lua_pushnil(L);
  lua_rawseti(L, kept, ++kept_count_);
  if (deep == 1) return;
  if (lua_getmetatable(L, table) != 0) add_table(L, kept, name, deep - 1);
  lua_settop(L, table);
  for_each_part(L, [&] {
    if (lua_istable(L, -1)) add_table(L, kept, name, deep - 1);
  });
}

std::string FileLocals::restore_tables(lua_State* L) const {
  if (tables_.empty()) return {};
  const int top = lua_gettop(L);
  luaL_checkstack(L, 8, nullptr);
  lua_rawgeti(L, LUA_REGISTRYINDEX, kept_);
  const int table = top + 2, copy = top + 3;
  std::string changed;
  for (const Table& known : tables_) {
    lua_rawgeti(L, top + 1, known.at);
    lua_rawgeti(L, top + 1, known.at + 1);
    std::size_t entries = 0;
    bool is_same = true;
    for (lua_pushnil(L); is_same && lua_next(L, table) != 0; lua_pop(L, 1)) {
      lua_pushvalue(L, -2);
      lua_rawget(L, copy);
      is_same = are_same(L, -1, -2) && ++entries <= known.entries;
      lua_pop(L, 1);
    }
    if (lua_getmetatable(L, table) == 0) lua_pushnil(L);
    lua_rawgeti(L, top + 1, known.at + 2);
    is_same = is_same && lua_rawequal(L, -1, -2) != 0;
    lua_settop(L, top + 1);
    if (is_same && entries == known.entries) continue;
    if (changed.empty()) changed = known.name;
    lua_rawgeti(L, top + 1, known.at);
    lua_rawgeti(L, top + 1, known.at + 1);
    for (lua_pushnil(L); lua_next(L, table) != 0;) {
      lua_pop(L, 1);
      lua_pushvalue(L, -1);
      lua_pushnil(L);
      lua_rawset(L, table);
    }
    for (lua_pushnil(L); lua_next(L, copy) != 0; lua_pop(L, 1)) {
      lua_pushvalue(L, -2);
      lua_pushvalue(L, -2);
      lua_rawset(L, table);
    }
    lua_rawgeti(L, top + 1, known.at + 2);
    set_metatable(L, table);
    lua_settop(L, top + 1);
  }
  lua_settop(L, top);
  return changed;
}

std::string FileLocals::restore(lua_State* L) const {
  const std::string changed = restore_locals(L);
  const std::string changed_table = restore_tables(L);
  return changed.empty() ? changed_table : changed;
}

std::string FileLocals::restore_locals(lua_State* L) const {
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
