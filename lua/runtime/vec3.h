// The vector type of scripts: a table with x, y, z and a shared metatable with + - * / (by
// numbers), == and the methods length, dot, cross.
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>

#include "base/vector.h"

namespace lsos {

void push_vec3(lua_State* L, const Vec3& v);
bool is_vec3(lua_State* L, int index);

// The vec3 at `index`; absent unless it is a vec3 with three finite numbers. Sets `has_integers`
// where one of them is of Lua's kind of whole numbers, which the result does not tell.
std::optional<Vec3> to_vec3(lua_State* L, int index, bool* has_integers = nullptr);

// Noun for a value that is not a vec3 of finite numbers, for messages.
std::string describe_no_vec3(lua_State* L, int index);

// Reads a function argument as a vec3; raises an error when it is something else.
Vec3 check_vec3(lua_State* L, int argument);

}  // namespace lsos
