#include <fmt/format.h>

#include <string>

#include "base/error.h"
#include "lua/plan_table.h"
#include "lua/sim_functions.h"
#include "lua/state.h"

namespace lsos {

namespace {

RoverAgent& agent_of(lua_State* L, int argument) {
  Simulation& simulation = sim_session(L).simulation();
  const std::string id = luaL_checkstring(L, argument);
  RoverAgent* agent = simulation.agent(id);
  if (agent == nullptr) {
    throw std::runtime_error(
        fmt::format("there is no rover '{}'{}", id, did_you_mean(id, simulation.rover_ids())));
  }
  return *agent;
}

}  // namespace

int sim_dispatch(lua_State* L) {
  SimSession& session = sim_session(L);
  const std::string rover_id = luaL_checkstring(L, 2), type = luaL_checkstring(L, 3);
  if (!lua_isnoneornil(L, 4)) luaL_checktype(L, 4, LUA_TTABLE);
  lua_settop(L, 4);
  // { type, fields... }, so that an event reads alike everywhere.
  lua_newtable(L);
  lua_pushstring(L, type.c_str());
  lua_rawseti(L, -2, 1);
  if (lua_istable(L, 4)) {
    for (lua_pushnil(L); lua_next(L, 4) != 0; lua_pop(L, 1)) {
      lua_pushvalue(L, -2);
      lua_pushvalue(L, -2);
      lua_rawset(L, 5);
    }
  }
  lua_pushinteger(
      L, session.dispatch(rover_id, read_event_table(L, 5, session.simulation().ground().site(),
                                                     caller_place(L))));
  return 1;
}

int sim_shade(lua_State* L) {
  const double share = luaL_checknumber(L, 3);
  if (!(share >= 0 && share <= 1)) {
    throw std::runtime_error(
        fmt::format("sim:shade: {}; a share of the sunlight is 0 to 1", share));
  }
  agent_of(L, 2).power().set_shade(share);
  return 0;
}

int sim_set_wheel(lua_State* L) {
  static constexpr const char* modes[] = {"driven", "free", "locked", nullptr};
  const int mode = luaL_checkoption(L, 4, "locked", modes);
  agent_of(L, 2).set_wheel(luaL_checkstring(L, 3), static_cast<WheelMode>(mode));
  return 0;
}

int sim_stick_panel(lua_State* L) {
  const bool is_stuck = lua_isnoneornil(L, 4) || lua_toboolean(L, 4) != 0;
  agent_of(L, 2).power().set_panel_stuck(luaL_optstring(L, 3, ""), is_stuck);
  return 0;
}

int sim_silence(lua_State* L) {
  agent_of(L, 2).set_silent(lua_isnoneornil(L, 3) || lua_toboolean(L, 3) != 0);
  return 0;
}

int sim_set_soil(lua_State* L) {
  SimSession& session = sim_session(L);
  session.simulation().take_soil(session.files().catalog->load_soil(luaL_checkstring(L, 2)));
  return 0;
}

}  // namespace lsos
