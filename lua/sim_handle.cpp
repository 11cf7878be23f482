// `sim`: a simulation in hand.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "lua/handle.h"
#include "lua/plan_table.h"
#include "lua/sims.h"
#include "lua/state.h"
#include "product/files.h"

namespace lsos {

namespace {

ScriptInstance number_of(lua_State* L) { return handle_id(L, sim_handle_type()); }

SimSession& session_of(lua_State* L) {
  const ScriptInstance number = number_of(L);
  return running_sims(L, "sim").at(number);
}

RoverAgent& agent_of(lua_State* L, int argument) {
  Simulation& simulation = session_of(L).simulation();
  const std::string id = luaL_checkstring(L, argument);
  RoverAgent* agent = simulation.agent(id);
  if (agent == nullptr) {
    throw std::runtime_error(
        fmt::format("there is no rover '{}'{}", id, did_you_mean(id, simulation.rover_ids())));
  }
  return *agent;
}

void set_text(lua_State* L, const char* key, const std::string& value) {
  lua_pushlstring(L, value.data(), value.size());
  lua_setfield(L, -2, key);
}

void set_quantity(lua_State* L, const char* key, double value) {
  push_quantity(L, value);
  lua_setfield(L, -2, key);
}

void set_time(lua_State* L, const char* key, std::optional<SimTime> time) {
  set_quantity(L, key, time ? seconds(*time) : not_modelled);
}

int time_s(lua_State* L) {
  lua_pushnumber(L, seconds(session_of(L).now()));
  return 1;
}

int is_finished(lua_State* L) {
  lua_pushboolean(L, session_of(L).simulation().is_finished());
  return 1;
}

int folder(lua_State* L) {
  lua_pushstring(L, session_of(L).folder().c_str());
  return 1;
}

int rovers(lua_State* L) {
  const ScriptInstance number = number_of(L);
  Sims& sims = running_sims(L, "sim");
  lua_newtable(L);
  for (const std::string& id : sims.at(number).simulation().rover_ids()) {
    push_handle(L, rover_handle_type(), sims.handle(number, id));
    lua_setfield(L, -2, id.c_str());
  }
  return 1;
}

void push_event(lua_State* L, const EventRow& row, const EventRecord& record) {
  lua_newtable(L);
  set_text(L, "rover", row.rover_id);
  lua_pushinteger(L, row.sequence);
  lua_setfield(L, -2, "sequence");
  set_text(L, "type", row.type);
  set_text(L, "label", row.label);
  set_text(L, "status", to_string(record.status));
  set_text(L, "reason", row.reason);
  set_time(L, "ready_s", row.ready);
  set_time(L, "start_s", row.start);
  set_time(L, "end_s", row.end);
  set_quantity(L, "distance_m", row.distance_m);
  set_quantity(L, "energy_used_j", row.energy_used_j);
  set_quantity(L, "solar_j", row.solar_j);
}

template <class Visit>
void for_each_event(lua_State* L, const Visit& visit) {
  Simulation& simulation = session_of(L).simulation();
  for (const std::string& id : simulation.rover_ids()) {
    const EventSequence& sequence = *simulation.sequence(id);
    for (std::size_t i = 0; i < sequence.records().size(); ++i) {
      if (visit(sequence.row(i), sequence.records()[i])) return;
    }
  }
}

int events(lua_State* L) {
  lua_newtable(L);
  lua_Integer count = 0;
  const int list = lua_gettop(L);
  for_each_event(L, [&](const EventRow& row, const EventRecord& record) {
    push_event(L, row, record);
    lua_rawseti(L, list, ++count);
    return false;
  });
  return 1;
}

int event(lua_State* L) {
  const std::string name = luaL_checkstring(L, 2);
  std::vector<std::string> names;
  bool is_found = false;
  for_each_event(L, [&](const EventRow& row, const EventRecord& record) {
    const std::string identity = fmt::format("{}/{}", row.rover_id, row.sequence);
    is_found = name == identity || name == row.label;
    if (is_found) push_event(L, row, record);
    names.push_back(identity);
    names.push_back(row.label);
    return is_found;
  });
  if (is_found) return 1;
  throw std::runtime_error(fmt::format("there is no event '{}'{}; there are {}", name,
                                       did_you_mean(name, names), fmt::join(names, ", ")));
}

void push_json(lua_State* L, const nlohmann::json& value) {
  if (value.is_object()) {
    lua_newtable(L);
    for (const auto& [key, member] : value.items()) {
      push_json(L, member);
      lua_setfield(L, -2, key.c_str());
    }
  } else if (value.is_array()) {
    lua_newtable(L);
    lua_Integer count = 0;
    for (const nlohmann::json& member : value) {
      push_json(L, member);
      lua_rawseti(L, -2, ++count);
    }
  } else if (value.is_string()) {
    lua_pushstring(L, value.get<std::string>().c_str());
  } else if (value.is_boolean()) {
    lua_pushboolean(L, value.get<bool>());
  } else if (value.is_number_integer()) {
    lua_pushinteger(L, value.get<lua_Integer>());
  } else if (value.is_number()) {
    lua_pushnumber(L, value.get<double>());
  } else {
    lua_pushnil(L);
  }
}

int notes(lua_State* L) {
  SimSession& session = session_of(L);
  const std::string name = luaL_optstring(L, 2, "");
  lua_newtable(L);
  lua_Integer count = 0;
  for (const NoteRow& row : session.notes()) {
    if (!name.empty() && row.name != name) continue;
    lua_newtable(L);
    set_quantity(L, "time_s", seconds(row.time));
    set_text(L, "rover", row.rover_id);
    lua_pushinteger(L, row.sequence);
    lua_setfield(L, -2, "sequence");
    set_text(L, "name", row.name);
    push_json(L, nlohmann::json::parse(row.fields_json));
    lua_setfield(L, -2, "fields");
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

int step(lua_State* L) {
  session_of(L).step(luaL_optinteger(L, 2, 1));
  return 0;
}

double check_duration(lua_State* L, int argument, const char* what) {
  constexpr double longest_s = 1e9;
  const double duration_s = luaL_checknumber(L, argument);
  if (duration_s >= 0 && duration_s <= longest_s) return duration_s;
  throw std::runtime_error(
      fmt::format("{}: {} s; 0 to {} are allowed", what, duration_s, longest_s));
}

int run_for(lua_State* L) {
  session_of(L).run_for(check_duration(L, 2, "sim:run_for"));
  return 0;
}

int run_until(lua_State* L) {
  SimSession& session = session_of(L);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  const double limit_s =
      lua_isnoneornil(L, 3) ? 366 * 86400.0 : check_duration(L, 3, "sim:run_until");
  lua_settop(L, 2);
  lua_pushvalue(L, 1);
  const bool is_enough = session.run_until(
      [&] {
        lua_pushvalue(L, 2);
        lua_pushvalue(L, 1);
        lua_call(L, 1, 1);
        const bool answer = lua_toboolean(L, -1) != 0;
        lua_pop(L, 1);
        return answer;
      },
      limit_s);
  lua_pushboolean(L, is_enough);
  return 1;
}

int run(lua_State* L) {
  session_of(L).run();
  return 0;
}

int step_phase(lua_State* L) {
  session_of(L).step_phase();
  return 0;
}

// "812.4 s  SEV1  leg 2: drive   10.00002,20.00001  1.2 m/s  charge 84 %"
int where(lua_State* L) {
  SimSession& session = session_of(L);
  std::string text = fmt::format("{} s", seconds(session.now()));
  if (session.simulation().is_finished()) text += ", the mission has ended";
  for (const std::string& id : session.simulation().rover_ids()) {
    const RoverAgent& agent = *session.simulation().agent(id);
    const EventSequence& sequence = *session.simulation().sequence(id);
    const RoverView& view = agent.view();
    const std::string doing =
        sequence.event_label().empty()
            ? sequence.is_finished() ? "has no event left" : "waits"
            : fmt::format("'{}' in {}", sequence.event_label(), sequence.phase());
    const Geodetic place = agent.place_now();
    text += fmt::format("\n{}  {}  {:.6f},{:.6f}  {:.2f} m/s  {:.1f} m driven", id, doing,
                        lon_deg(place), lat_deg(place), view.speed_mps, view.distance_m);
    const double charge = agent.power().view().charge;
    if (agent.power().has_battery()) text += fmt::format("  charge {:.1f} %", 100 * charge);
  }
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

int dispatch(lua_State* L) {
  SimSession& session = session_of(L);
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

int save(lua_State* L) {
  const std::filesystem::path file = luaL_checkstring(L, 2);
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  write_file(file, session_of(L).save());
  return 0;
}

int load(lua_State* L) {
  const std::string file = luaL_checkstring(L, 2);
  const auto bytes = read_file(file);
  if (!bytes) throw std::runtime_error(fmt::format("{} cannot be read", file));
  try {
    session_of(L).load(*bytes);
  } catch (const InputError& error) {
    throw std::runtime_error(fmt::format("{} {}", file, error.what()));
  }
  return 0;
}

int reload(lua_State* L) {
  session_of(L).reload();
  return 0;
}

int shade(lua_State* L) {
  const double share = luaL_checknumber(L, 3);
  if (!(share >= 0 && share <= 1)) {
    throw std::runtime_error(
        fmt::format("sim:shade: {}; a share of the sunlight is 0 to 1", share));
  }
  agent_of(L, 2).power().set_shade(share);
  return 0;
}

int set_wheel(lua_State* L) {
  static constexpr const char* modes[] = {"driven", "free", "locked", nullptr};
  const int mode = luaL_checkoption(L, 4, "locked", modes);
  agent_of(L, 2).set_wheel(luaL_checkstring(L, 3), static_cast<WheelMode>(mode));
  return 0;
}

int stick_panel(lua_State* L) {
  const bool is_stuck = lua_isnoneornil(L, 4) || lua_toboolean(L, 4) != 0;
  agent_of(L, 2).power().set_panel_stuck(luaL_optstring(L, 3, ""), is_stuck);
  return 0;
}

int silence(lua_State* L) {
  agent_of(L, 2).set_silent(lua_isnoneornil(L, 3) || lua_toboolean(L, 3) != 0);
  return 0;
}

int set_soil(lua_State* L) {
  SimSession& session = session_of(L);
  session.simulation().take_soil(session.files().catalog->load_soil(luaL_checkstring(L, 2)));
  return 0;
}

}  // namespace

int make_sim(lua_State* L) {
  Sims& sims = running_sims(L, "lsos.sim");
  luaL_checkany(L, 1);
  const ScriptInstance number =
      lua_istable(L, 1) ? sims.open(L, 1, caller_place(L)) : sims.open(luaL_checkstring(L, 1));
  push_handle(L, sim_handle_type(), number);
  return 1;
}

const HandleType& sim_handle_type() {
  static const HandleType type{
      "sim",
      "A simulation in hand: of a scenario or the prompt. It stands still between two calls.",
      {{"time_s", guard<time_s>, "number", "Since the mission's start."},
       {"is_finished", guard<is_finished>, "boolean", "No event is left."},
       {"rovers", guard<rovers>, "table of rover", "By RoverId: all that `rover` has in a phase."},
       {"events", guard<events>, "list of tables",
        "`rover`, `sequence`, `type`, `label`, `status`, `reason`, `ready_s`, `start_s`, `end_s`, "
        "`distance_m`, `energy_used_j`, `solar_j`."},
       {"folder", guard<folder>, "text", "Where its log is."}},
      {{"step", guard<step>, "sim:step(n)",
        "To the next exchange, n times: 0.1 s while something moves, else when something happens."},
       {"run_for", guard<run_for>, "sim:run_for(duration_s)", "So long, or to the mission's end."},
       {"run_until", guard<run_until>, "sim:run_until(function, limit_s)",
        "Until the function of sim answers true; false when the limit or the end came first. It is "
        "asked at each exchange, over quiet time at whole seconds."},
       {"run", guard<run>, "sim:run()", "To the mission's end."},
       {"step_phase", guard<step_phase>, "sim:step_phase()", "Until a rover enters another phase."},
       {"where", guard<where>, "sim:where()", "What all rovers do, as a text."},
       {"event", guard<event>, "sim:event(name)", "The one with that label, or ROVER/SEQUENCE."},
       {"notes", guard<notes>, "sim:notes(name)",
        "What events logged, findings, decisions: `time_s`, `rover`, `sequence`, `name`, "
        "`fields`; of that name, or all."},
       {"dispatch", guard<dispatch>, "sim:dispatch(rover_id, type, { Field = , path = , at = })",
        "One more event, after those that have begun; answers its Sequence."},
       {"save", guard<save>, "sim:save(file)", "Writes all of its state."},
       {"load", guard<load>, "sim:load(file)", "Goes back to it. The log begins anew there."},
       {"reload", guard<reload>, "sim:reload()",
        "Reads event scripts anew: what has changed is called from the next phase on."},
       {"shade", guard<shade>, "sim:shade(rover_id, share)",
        "So much of the sunlight reaches the rover's panels, 0 to 1."},
       {"set_wheel", guard<set_wheel>, "sim:set_wheel(rover_id, wheel, mode)",
        "A wheel fails: 'locked' (when left out), 'free'; or works again: 'driven'."},
       {"stick_panel", guard<stick_panel>, "sim:stick_panel(rover_id, panel, is_stuck)",
        "A panel (all when left out) stays as it is."},
       {"silence", guard<silence>, "sim:silence(rover_id, is_silent)",
        "The rover's antennas work for nobody."},
       {"set_soil", guard<set_soil>, "sim:set_soil(name)", "The ground is of another soil now."}}};
  return type;
}

}  // namespace lsos
