// Text of script values for people: at the prompt, and in the failures of scenarios.
#pragma once

#include <lua.hpp>
#include <string>

namespace lsos {

// The value on one line, in Lua's notation: 'text', { 1, 2, name = 'x' }.
std::string written_value(lua_State* L, int index);

// The value with the unit in `name` ("1.97 m/s" for speed_mps). The members of a table or an object
// follow, one on each line, with the units in their names. May call a script's __tostring.
std::string shown_value(lua_State* L, int index, const std::string& name);

}  // namespace lsos
