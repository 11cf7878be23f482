// The environment in which a script runs: the globals that it can read.
#pragma once

#include <lua.hpp>

#include "lua/runtime/script.h"

namespace lsos {

// Takes the table at the top of the stack as the globals of all scripts. Once a state.
void keep_globals(lua_State* L);

// Pushes a new environment for one script file.
void push_environment(lua_State* L);
// Pushes an environment that accepts globals, for a prompt.
void push_open_environment(lua_State* L);

// Runs a script in an environment of its own, within the call of another script, and pushes what
// it returns. Its errors are the caller's; throws std::runtime_error when it is not Lua.
void run_within(lua_State* L, const Script& script);

}  // namespace lsos
