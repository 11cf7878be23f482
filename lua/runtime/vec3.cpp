#include "lua/runtime/vec3.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "lua/runtime/constructed_value.h"
#include "lua/runtime/read_only.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"

namespace lsos {

namespace {

constexpr const char* metatable_name = "lsos.vec3";

int add(lua_State* L) {
  push_vec3(L, check_vec3(L, 1) + check_vec3(L, 2));
  return 1;
}

int subtract(lua_State* L) {
  push_vec3(L, check_vec3(L, 1) - check_vec3(L, 2));
  return 1;
}

int negate(lua_State* L) {
  push_vec3(L, -check_vec3(L, 1));
  return 1;
}

int multiply(lua_State* L) {
  const bool number_first = lua_type(L, 1) == LUA_TNUMBER;
  push_vec3(L, check_vec3(L, number_first ? 2 : 1) * luaL_checknumber(L, number_first ? 1 : 2));
  return 1;
}

int divide(lua_State* L) {
  push_vec3(L, check_vec3(L, 1) / luaL_checknumber(L, 2));
  return 1;
}

int equal(lua_State* L) {
  const std::optional<Vec3> a = to_vec3(L, 1), b = to_vec3(L, 2);
  lua_pushboolean(L, a && b && *a == *b);
  return 1;
}

int vec3_text(lua_State* L) {
  const Vec3 v = check_vec3(L, 1);
  lua_pushstring(L, fmt::format("({}, {}, {})", v.x(), v.y(), v.z()).c_str());
  return 1;
}

int length(lua_State* L) {
  lua_pushnumber(L, check_vec3(L, 1).norm());
  return 1;
}

int dot(lua_State* L) {
  lua_pushnumber(L, check_vec3(L, 1).dot(check_vec3(L, 2)));
  return 1;
}

int cross(lua_State* L) {
  push_vec3(L, check_vec3(L, 1).cross(check_vec3(L, 2)));
  return 1;
}

int refuse_key(lua_State* L) {
  throw std::runtime_error(
      fmt::format("a vec3 has x, y, z and no other keys, '{}' cannot be set", key_text(L, 2)));
}

void push_vec3_metatable(lua_State* L) {
  if (luaL_newmetatable(L, metatable_name) == 0) return;
  constexpr luaL_Reg functions[] = {{"__add", guard<add>},
                                    {"__sub", guard<subtract>},
                                    {"__unm", guard<negate>},
                                    {"__mul", guard<multiply>},
                                    {"__div", guard<divide>},
                                    {"__eq", guard<equal>},
                                    {"__tostring", guard<vec3_text>},
                                    {"__newindex", guard<refuse_key>},
                                    {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
  constexpr luaL_Reg methods[] = {
      {"length", guard<length>}, {"dot", guard<dot>}, {"cross", guard<cross>}, {nullptr, nullptr}};
  luaL_newlib(L, methods);
  make_read_only(L, "a vec3");
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
}

}  // namespace

void push_vec3(lua_State* L, const Vec3& v) {
  lua_createtable(L, 0, 3);
  lua_pushnumber(L, v.x());
  lua_setfield(L, -2, "x");
  lua_pushnumber(L, v.y());
  lua_setfield(L, -2, "y");
  lua_pushnumber(L, v.z());
  lua_setfield(L, -2, "z");
  push_vec3_metatable(L);
  lua_setmetatable(L, -2);
}

bool is_vec3(lua_State* L, int index) {
  if (!lua_istable(L, index) || lua_getmetatable(L, index) == 0) return false;
  luaL_getmetatable(L, metatable_name);
  const bool is = lua_rawequal(L, -1, -2) != 0;
  lua_pop(L, 2);
  return is;
}

std::optional<Vec3> to_vec3(lua_State* L, int index, bool* has_integers) {
  if (!is_vec3(L, index)) return {};
  index = lua_absindex(L, index);
  Vec3 v;
  constexpr const char* names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    lua_pushstring(L, names[i]);
    lua_rawget(L, index);
    const bool is_number = lua_type(L, -1) == LUA_TNUMBER;
    v[i] = lua_tonumber(L, -1);
    if (has_integers != nullptr && lua_isinteger(L, -1) != 0) *has_integers = true;
    lua_pop(L, 1);
    if (!is_number || !std::isfinite(v[i])) return {};
  }
  return v;
}

std::string describe_no_vec3(lua_State* L, int index) {
  return is_vec3(L, index) ? "a vec3 whose x, y, z are not all finite numbers" : describe(L, index);
}

Vec3 check_vec3(lua_State* L, int argument) {
  if (const std::optional<Vec3> v = to_vec3(L, argument)) return *v;
  const std::string found = describe_no_vec3(L, argument);
  luaL_argerror(L, argument, fmt::format("a vec3 is wanted, found {}", found).c_str());
  return Vec3::Zero();
}

}  // namespace lsos
