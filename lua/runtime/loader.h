// Runs a script file in its own environment and returns what it returns.
#pragma once

#include <lua.hpp>

#include "lua/runtime/constructed_value.h"
#include "lua/runtime/script.h"

namespace lsos {

// Pushes what the script returned. On faults, collects them, pushes nothing and returns false.
bool run_script(lua_State* L, const Script& script, Faults& faults);

// Pushes what the script returned, which lsos.`kind` must have made, and returns it. On faults,
// collects them, pushes nothing and returns nullptr.
const ConstructedValue* load_script(lua_State* L, const Script& script, const char* kind,
                                    Faults& faults);

}  // namespace lsos
