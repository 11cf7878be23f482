#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "lua/api/breakage.h"
#include "lua/host/plan_table.h"
#include "lua/runtime/state.h"
#include "lua/session/sim_functions.h"

namespace lsos {

namespace {

RoverAgent& agent_of(lua_State* L, int argument) {
  const Fleet& fleet = sim_session(L).simulation().fleet();
  const std::string id = luaL_checkstring(L, argument);
  const FleetRover* rover = fleet.find(id);
  if (rover == nullptr) {
    throw std::runtime_error(
        fmt::format("there is no rover '{}'{}", id, did_you_mean(id, fleet.rover_ids())));
  }
  return *rover->agent;
}

// Logs an interactive change to a rover as a note.
void note(lua_State* L, const std::string& rover_id, const char* name,
          const nlohmann::json& fields) {
  sim_session(L).simulation().note_interactive(
      rover_id, name, fields.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

// A run that begins as this one ends reads its breakages from these notes.
void inject(lua_State* L, RoverAgent& agent, const Breakage& breakage) {
  const std::string fields = agent.inject(breakage);
  sim_session(L).simulation().note_interactive(agent.id(), "fault", fields);
}

}  // namespace

int sim_dispatch(lua_State* L) {
  SimSession& session = sim_session(L);
  const std::string rover_id = luaL_checkstring(L, 2), type = luaL_checkstring(L, 3);
  if (!lua_isnoneornil(L, 4)) luaL_checktype(L, 4, LUA_TTABLE);
  lua_settop(L, 4);
  // Build { type, fields... }, the form that events have everywhere.
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
  const std::int64_t sequence = session.dispatch(
      rover_id, read_event_table(L, 5, session.simulation().ground().site(), caller_place(L)));
  note(L, rover_id, "dispatched", {{"sequence", sequence}, {"type", type}});
  lua_pushinteger(L, sequence);
  return 1;
}

int sim_shade(lua_State* L) {
  const double share = luaL_checknumber(L, 3);
  if (!(share >= 0 && share <= 1)) {
    throw std::runtime_error(
        fmt::format("sim:shade: {}; a share of the sunlight is 0 to 1", share));
  }
  RoverAgent& agent = agent_of(L, 2);
  agent.power().set_shade(share);
  note(L, agent.id(), "shaded", {{"share", share}});
  return 0;
}

int sim_fault(lua_State* L) {
  RoverAgent& agent = agent_of(L, 2);
  inject(L, agent, check_breakage(L, 3, "sim:fault"));
  return 0;
}

int sim_set_wheel(lua_State* L) {
  static constexpr const char* modes[] = {"driven", "free", "locked", nullptr};
  const std::string mode = modes[luaL_checkoption(L, 4, "locked", modes)];
  const std::string wheel = luaL_checkstring(L, 3);
  RoverAgent& agent = agent_of(L, 2);
  if (mode == "driven") {
    agent.inject_driven_wheel(wheel);
  } else {
    inject(L, agent, {.what = "wheel", .part = wheel, .mode = mode, .share = {}});
  }
  note(L, agent.id(), "wheel_set", {{"mode", mode}, {"wheel", wheel}});
  return 0;
}

int sim_stick_panel(lua_State* L) {
  const bool is_stuck = lua_isnoneornil(L, 4) || lua_toboolean(L, 4) != 0;
  const std::string panel = luaL_optstring(L, 3, "");
  RoverAgent& agent = agent_of(L, 2);
  inject(L, agent,
         {.what = "panel", .part = panel, .mode = "stuck", .share = {}, .is_repair = !is_stuck});
  note(L, agent.id(), "panel_stuck", {{"is_stuck", is_stuck}, {"panel", panel}});
  return 0;
}

int sim_silence(lua_State* L) {
  const bool is_silent = lua_isnoneornil(L, 3) || lua_toboolean(L, 3) != 0;
  RoverAgent& agent = agent_of(L, 2);
  inject(L, agent,
         {.what = "antenna", .part = "", .mode = "", .share = {}, .is_repair = !is_silent});
  note(L, agent.id(), "silenced", {{"is_silent", is_silent}});
  return 0;
}

int sim_set_soil(lua_State* L) {
  const std::string soil = luaL_checkstring(L, 2);
  sim_session(L).set_soil(soil);
  for (const std::string& id : sim_session(L).simulation().fleet().rover_ids()) {
    note(L, id, "soil_set", {{"soil", soil}});
  }
  return 0;
}

}  // namespace lsos
