// Fields and methods of `sim`, grouped by purpose; they are bound in sim_handle.cpp.
#pragma once

#include <lua.hpp>

#include "lua/session/sim_sessions.h"

namespace lsos {

// Number and session of the simulation whose handle is argument 1. Throw std::runtime_error.
ScriptInstance sim_number(lua_State* L);
SimSession& sim_session(lua_State* L);

// Queries (sim_queries.cpp).
int sim_time_s(lua_State* L);
int sim_is_finished(lua_State* L);
int sim_folder(lua_State* L);
int sim_rovers(lua_State* L);
int sim_events(lua_State* L);
int sim_event(lua_State* L);
int sim_notes(lua_State* L);
int sim_where(lua_State* L);
int sim_picture(lua_State* L);

// Changes to the simulated world and the plan (sim_changes.cpp).
int sim_dispatch(lua_State* L);
int sim_shade(lua_State* L);
int sim_fault(lua_State* L);
int sim_set_wheel(lua_State* L);
int sim_stick_panel(lua_State* L);
int sim_silence(lua_State* L);
int sim_set_soil(lua_State* L);

}  // namespace lsos
