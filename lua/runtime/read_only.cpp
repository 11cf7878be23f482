#include "lua/runtime/read_only.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"

namespace lsos {

namespace {

constexpr const char* maker_key = "is a script's";  // in the metatable of a view

std::vector<std::string> text_keys(lua_State* L, int index) {
  std::vector<std::string> keys;
  index = lua_absindex(L, index);
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    if (lua_type(L, -2) == LUA_TSTRING) keys.emplace_back(lua_tostring(L, -2));
    lua_pop(L, 1);
  }
  std::ranges::sort(keys);
  return keys;
}

// Upvalues: the table, its name ("" for the globals).
int missing_key(lua_State* L) {
  const std::string name = lua_tostring(L, lua_upvalueindex(2));
  const std::string key = key_text(L, 2);
  const std::string near = did_you_mean(key, text_keys(L, lua_upvalueindex(1)));
  throw std::runtime_error(name.empty() ? fmt::format("no global '{}'{}", key, near)
                                        : fmt::format("{} has no '{}'{}", name, key, near));
}

}  // namespace

int refuse_assignment(lua_State* L) {
  const std::string name = lua_tostring(L, lua_upvalueindex(1));
  const std::string key = key_text(L, 2);
  throw std::runtime_error(
      name.empty() ? fmt::format("assignment to global '{}': make it local", key)
                   : fmt::format("{} is read-only, '{}' cannot be assigned", name, key));
}

bool is_metatable_of_view(lua_State* L, int index) {
  index = lua_absindex(L, index);
  const auto has = [&](const char* key, lua_CFunction function) {
    lua_pushstring(L, key);
    lua_rawget(L, index);
    const bool is_it = lua_tocfunction(L, -1) == function;
    lua_pop(L, 1);
    return is_it;
  };
  return has("__newindex", guard<refuse_assignment>) || has("__index", guard<missing_key>);
}

bool is_view(lua_State* L, int index) {
  if (!lua_istable(L, index) || lua_getmetatable(L, index) == 0) return false;
  lua_pushliteral(L, "__newindex");
  lua_rawget(L, -2);
  const bool is = lua_tocfunction(L, -1) == guard<refuse_assignment>;
  lua_pop(L, 2);
  return is;
}

bool push_shown_script(lua_State* L, int view) {
  if (lua_getmetatable(L, view) == 0) return false;
  const int metatable = lua_gettop(L);
  lua_getfield(L, metatable, maker_key);
  const bool is_scripts = lua_toboolean(L, -1) != 0;
  lua_settop(L, is_scripts ? metatable : metatable - 1);
  if (!is_scripts) return false;
  lua_getfield(L, metatable, "__index");
  lua_remove(L, metatable);
  return true;
}

void make_read_only(lua_State* L, const char* name, Maker maker) {
  const int real = lua_gettop(L);
  // The table answers what it has; only what it lacks comes to the function.
  lua_newtable(L);
  lua_pushvalue(L, real);
  lua_pushstring(L, name);
  lua_pushcclosure(L, guard<missing_key>, 2);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, real);

  lua_newtable(L);  // the view
  lua_newtable(L);
  lua_pushvalue(L, real);
  lua_setfield(L, -2, "__index");
  lua_pushstring(L, name);
  lua_pushcclosure(L, guard<refuse_assignment>, 1);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pushboolean(L, maker == Maker::script);
  lua_setfield(L, -2, maker_key);
  lua_setmetatable(L, -2);
  lua_remove(L, real);
}

}  // namespace lsos
