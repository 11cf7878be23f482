// The lsos module of scenarios and prompts: that of event scripts, and simulations besides.
#pragma once

#include <lua.hpp>
#include <vector>

#include "lua/api/api.h"

namespace lsos {

const std::vector<ApiFunction>& session_functions();
// Those of all modules, and these.
std::vector<ApiFunction> all_functions();

// Makes the module of a scenario's or a prompt's state.
void make_session_api(lua_State* L);

}  // namespace lsos
