// The one small value type of scripts: a table with x, y, z and a shared metatable with + - * /
// (by numbers), == and the methods length, dot, cross.
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>

#include "base/vector.h"

namespace lsos {

void push_vec3(lua_State* L, const Vec3& v);
bool is_vec3(lua_State* L, int index);

// Reads the value at `index`, which must be a vec3 with three finite numbers.
std::optional<Vec3> to_vec3(lua_State* L, int index);

// What stands in place of a vec3 of finite numbers, for messages.
std::string describe_no_vec3(lua_State* L, int index);

// The same for an argument of a function; raises when it is something else.
Vec3 check_vec3(lua_State* L, int argument);

}  // namespace lsos
