// Values of scripts as people read them: at the prompt, and in what a scenario found.
#pragma once

#include <lua.hpp>
#include <string>

namespace lsos {

// On one line, as it is written: 'text', { 1, 2, name = 'x' }.
std::string written_value(lua_State* L, int index);

// With the unit that `name` says ("1.97 m/s" of speed_mps); what a table or an object holds
// follows, a line each, with the units that the names there say. May call a script's __tostring.
std::string shown_value(lua_State* L, int index, const std::string& name);

}  // namespace lsos
