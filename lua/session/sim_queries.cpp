#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "base/output_file.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/session/picture_session.h"
#include "lua/session/sim_functions.h"
#include "picture/png.h"

namespace lsos {

namespace {

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

// __index of an event table: throws for a key that events do not have.
int refuse_event_key(lua_State* L) {
  static const std::vector<std::string> known{"rover",  "sequence",   "type",          "label",
                                              "status", "reason",     "ready_s",       "start_s",
                                              "end_s",  "distance_m", "energy_used_j", "solar_j"};
  const std::string wanted = key_text(L, 2);
  if (std::ranges::find(known, wanted) != known.end()) return 0;  // a key without a value
  throw std::runtime_error(fmt::format("an event has no '{}'{}; it has {}", wanted,
                                       did_you_mean(wanted, known), fmt::join(known, ", ")));
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
  lua_newtable(L);
  lua_pushcfunction(L, guard<refuse_event_key>);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

template <class Visit>
void for_each_event(lua_State* L, const Visit& visit) {
  for (const FleetRover& rover : sim_session(L).simulation().fleet().rovers) {
    const EventSequence& sequence = rover.sequence;
    for (std::size_t i = 0; i < sequence.records().size(); ++i) {
      if (visit(sequence.row(i), sequence.records()[i])) return;
    }
  }
}

// __index of sim.rovers: throws for a rover that does not exist.
int refuse_rover(lua_State* L) {
  std::vector<std::string> ids;
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) ids.push_back(key_text(L, -2));
  std::ranges::sort(ids);
  const std::string wanted = key_text(L, 2);
  throw std::runtime_error(fmt::format("there is no rover '{}'{}; there are {}", wanted,
                                       did_you_mean(wanted, ids), fmt::join(ids, ", ")));
}

void push_json(lua_State* L, const nlohmann::json& value) {
  luaL_checkstack(L, 4, "fields of a note are nested too deep");
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

}  // namespace

int sim_time_s(lua_State* L) {
  lua_pushnumber(L, seconds(sim_session(L).now()));
  return 1;
}

int sim_is_finished(lua_State* L) {
  lua_pushboolean(L, sim_session(L).simulation().is_finished());
  return 1;
}

int sim_folder(lua_State* L) {
  lua_pushstring(L, sim_session(L).folder().c_str());
  return 1;
}

int sim_rovers(lua_State* L) {
  const ScriptInstance number = sim_number(L);
  SimSessions& sims = running_sessions(L, "sim");
  lua_newtable(L);
  lua_newtable(L);
  lua_pushcfunction(L, guard<refuse_rover>);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  for (const std::string& id : sims.at(number).simulation().fleet().rover_ids()) {
    push_handle(L, rover_handle_type(), sims.handle(number, id));
    lua_setfield(L, -2, id.c_str());
  }
  return 1;
}

int sim_events(lua_State* L) {
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

int sim_event(lua_State* L) {
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

int sim_notes(lua_State* L) {
  SimSession& session = sim_session(L);
  const std::string name = luaL_optstring(L, 2, "");
  if (!session.has_all_notes()) {
    throw std::runtime_error(
        fmt::format("sim:notes: the mission has written more notes than are kept ({}); its log has "
                    "all, in the table notes",
                    session.notes().size()));
  }
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

// State of all rovers: "812.4 s", then one line each: "SEV1  'leg 2' in drive  10.000020,20.000010
// deg  1.20 m/s  ...".
int sim_where(lua_State* L) {
  SimSession& session = sim_session(L);
  std::string text = fmt::format("{} s", seconds(session.now()));
  if (session.simulation().is_finished()) text += ", the mission has ended";
  for (const FleetRover& rover : session.simulation().fleet().rovers) {
    const RoverAgent& agent = *rover.agent;
    const EventSequence& sequence = rover.sequence;
    const RoverView& view = agent.view();
    const std::string doing =
        sequence.event_label().empty()
            ? sequence.is_finished() ? "has no event left" : "waits"
            : fmt::format("'{}' in {}", sequence.event_label(), sequence.phase());
    const Geodetic place = agent.motion().place();
    text += fmt::format("\n{}  {}  {:.6f},{:.6f} deg  {:.2f} m/s  {:.1f} m driven", agent.id(),
                        doing, lon_deg(place), lat_deg(place), view.speed_mps, view.distance_m);
    const double charge = agent.power().view().charge;
    if (agent.power().has_battery()) text += fmt::format("  charge {:.1f} %", 100 * charge);
  }
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

int sim_picture(lua_State* L) {
  SimSession& session = sim_session(L);
  const std::string file = luaL_optstring(L, 2, "");
  if (!lua_isnoneornil(L, 3)) luaL_checktype(L, 3, LUA_TTABLE);
  lua_settop(L, 3);
  PictureRequest request;
  if (lua_istable(L, 3)) {
    Faults faults;
    TableReader reader(L, 3, "sim:picture", caller_place(L), faults);
    std::optional<double> size_px;
    reader.text(optional, "from", request.from, "");
    reader.text(optional, "rover", request.rover, "");
    reader.number(optional, "size_px", size_px, {64, 8192}, "");
    reader.finish();
    faults.throw_if_errors();
    if (size_px) request.size_px = static_cast<int>(*size_px);
  }
  const std::string picture =
      file.empty() ? fmt::format("{}/{}_s.png", session.folder(), seconds(session.now())) : file;
  Faults faults;
  check_output("sim:picture", picture, {".png"}, {}, faults);
  faults.throw_if_errors();
  check_replaceable(picture, png_mark);
  write_picture(session, request, picture);
  lua_pushstring(L, picture.c_str());
  return 1;
}

}  // namespace lsos
