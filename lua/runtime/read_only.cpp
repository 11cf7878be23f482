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

void make_read_only(lua_State* L, const char* name) {
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
  lua_setmetatable(L, -2);
  lua_remove(L, real);
}

}  // namespace lsos
