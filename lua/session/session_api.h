// The lsos module of scenarios and prompts: that of event scripts, and simulations besides.
#pragma once

#include <lua.hpp>
#include <vector>

#include "lua/api/api.h"
#include "lua/runtime/context.h"

namespace lsos {

const std::vector<ApiFunction>& session_functions();
// Those of all modules, and these.
std::vector<ApiFunction> all_functions();

// What a script in a session may take: some 20 s of instructions, and any time for simulating.
Limits session_limits();

// Makes the module of a scenario's or a prompt's state.
void make_session_api(lua_State* L);

}  // namespace lsos
