#include "lua/runtime/sandbox.h"

#include "lua/runtime/environment.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "lua/runtime/read_only.h"
#include "lua/runtime/sandbox_base.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

// Functions taken from Lua unchanged.
constexpr const char* base_functions[] = {"assert", "error",  "ipairs", "rawequal",
                                          "rawget", "rawlen", "select", "type"};
// Functions removed from libraries: those that are not repeatable (random, randomseed) and those
// for binary code (dump).
constexpr const char* math_absent[] = {"random", "randomseed"};
constexpr const char* string_absent[] = {"dump"};

void push_library(lua_State* L, const char* name, lua_CFunction open) {
  luaL_requiref(L, name, open, 0);
}

template <std::size_t count>
void remove_fields(lua_State* L, const char* const (&names)[count]) {
  for (const char* name : names) {
    lua_pushnil(L);
    lua_setfield(L, -2, name);
  }
}

}  // namespace

void make_sandbox(lua_State* L) {
  lua_newtable(L);  // all globals of scripts
  push_library(L, LUA_GNAME, luaopen_base);
  for (const char* name : base_functions) {
    lua_getfield(L, -1, name);
    lua_setfield(L, -3, name);
  }
  lua_pop(L, 1);
  add_base_functions(L);

  push_library(L, LUA_STRLIBNAME, luaopen_string);
  remove_fields(L, string_absent);
  replace_string_functions(L);
  // Method calls on texts ('x'):rep(3) go through the texts' metatable: the same functions.
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  replace_text_arithmetic(L);
  lua_pop(L, 2);
  make_read_only(L, "string");
  lua_setfield(L, -2, "string");

  push_library(L, LUA_MATHLIBNAME, luaopen_math);
  remove_fields(L, math_absent);
  make_read_only(L, "math");
  lua_setfield(L, -2, "math");

  push_library(L, LUA_TABLIBNAME, luaopen_table);
  replace_table_functions(L);
  make_read_only(L, "table");
  lua_setfield(L, -2, "table");

  push_library(L, LUA_UTF8LIBNAME, luaopen_utf8);
  replace_utf8_functions(L);
  make_read_only(L, "utf8");
  lua_setfield(L, -2, "utf8");

  make_read_only(L, "");
  keep_globals(L);
}

}  // namespace lsos
