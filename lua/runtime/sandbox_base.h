// The base functions that differ from Lua's own: pairs, tostring, pcall, xpcall, print, require,
// setmetatable, getmetatable, rawset.
#pragma once

#include <lua.hpp>

namespace lsos {

// Adds them to the table at the top of the stack.
void add_base_functions(lua_State* L);

}  // namespace lsos
