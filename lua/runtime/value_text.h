// Values of scripts as texts without addresses, which would differ from run to run.
#pragma once

#include <lua.hpp>
#include <string>

namespace lsos {

// Text of any value: "rover 'A'", "table", "function". Pushes it.
void push_text(lua_State* L, int index);

// A key as messages show it: long ones are cut.
std::string key_text(lua_State* L, int index);

}  // namespace lsos
