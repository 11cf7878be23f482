// What scripts of scenarios call: lsos.scenario, and `t` with its expectations.
#pragma once

#include <lua.hpp>

namespace lsos {

// `t`, what a scenario says its expectations to.
const struct HandleType& scenario_handle_type();

// lsos.scenario(name, function)
int add_scenario(lua_State* L);

// Pushes the scenarios of the file that was loaded: a list of { name, function }.
void push_scenarios(lua_State* L);

}  // namespace lsos
