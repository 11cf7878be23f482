// `ev`: what an event was given, what it remembers, and its times.
#include <fmt/format.h>

#include <string>

#include "base/utf8.h"
#include "lua/api/answer.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/json.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "mission/port/note_json.h"

namespace lsos {

namespace {

constexpr std::size_t warning_bytes_max = 1000;

const EventCall& call_of(lua_State* L) { return handle_call(L, event_handle_type()); }

// The handle's user value is the table { params = , geometry = , state = }.
int read_stored(lua_State* L, const char* name) {
  call_of(L);
  lua_getiuservalue(L, 1, 1);
  lua_getfield(L, -1, name);
  return 1;
}

int params(lua_State* L) { return read_stored(L, "params"); }
int geometry(lua_State* L) { return read_stored(L, "geometry"); }
int state(lua_State* L) { return read_stored(L, "state"); }

int label(lua_State* L) {
  lua_pushstring(L, call_of(L).phase.label.c_str());
  return 1;
}

int sequence(lua_State* L) {
  lua_pushinteger(L, call_of(L).phase.sequence);
  return 1;
}

int time_s(lua_State* L) {
  lua_pushnumber(L, seconds(call_of(L).phase.now));
  return 1;
}

int elapsed_s(lua_State* L) {
  const PhaseContext& phase = call_of(L).phase;
  lua_pushnumber(L, seconds(phase.now - phase.event_start));
  return 1;
}

int phase_elapsed_s(lua_State* L) {
  const PhaseContext& phase = call_of(L).phase;
  lua_pushnumber(L, seconds(phase.now - phase.phase_start));
  return 1;
}

int log(lua_State* L) {
  const EventCall& call = call_of(L);
  const std::string name = luaL_checkstring(L, 2);
  if (name.empty()) throw std::runtime_error("ev:log wants a name that is not empty");
  if (!lua_isnoneornil(L, 3)) luaL_checktype(L, 3, LUA_TTABLE);
  lua_settop(L, 3);
  write_note(L, call, name, fields_json(L, 3));
  return 0;
}

// Adds a warning to the summary and the report, and a note that shows where it was given.
int warn(lua_State* L) {
  const EventCall& call = call_of(L);
  lua_remove(L, 1);
  const std::string text = beginning(formatted(L), warning_bytes_max);
  write_note(L, call, "warning", fmt::format(R"({{"text":{}}})", note_json(text)));
  call.phase.rover.warn(fmt::format("{} of {}: {}", call.phase.label, call.phase.rover_id, text));
  return 0;
}

int write(lua_State* L) {
  call_of(L);
  const std::string key = lua_type(L, 2) == LUA_TSTRING ? key_text(L, 2) : "?";
  if (key != "state") {
    throw std::runtime_error(fmt::format(
        "ev is read-only, '{}' cannot be assigned; what an event remembers goes into ev.state",
        key));
  }
  if (!lua_istable(L, 3)) throw std::runtime_error("ev.state must be a table");
  lua_getiuservalue(L, 1, 1);
  lua_pushvalue(L, 3);
  lua_setfield(L, -2, "state");
  return 0;
}

}  // namespace

const HandleType& event_handle_type() {
  static const HandleType type{
      "ev",
      "The event that runs.",
      {{"params", params, "table", "The plan's fields by script key, SI, read-only."},
       {"geometry", geometry, "ev.geometry",
        "Waypoints in the site frame, m, read-only; of a polygon each corner once."},
       {"state", state, "table", "What the event remembers; all that lives between two calls."},
       {"label", label, "text", "The event's name in the plan."},
       {"sequence", sequence, "integer", "Its Sequence in the plan."},
       {"time_s", time_s, "number", "Now, since the mission's start."},
       {"elapsed_s", elapsed_s, "number", "Since the event's first phase began."},
       {"phase_elapsed_s", phase_elapsed_s, "number", "Since this phase began."}},
      {{"log", guard<log>, "ev:log(name, fields)",
        "Writes a row into the log's notes; fields is a table of plain values or nil.",
        "fun(self: lsos.ev, name: string, fields?: table)"},
       {"warn", guard<warn>, "ev:warn(format, ...)",
        "A warning in the run's summary and report, and a note; the text as string.format makes "
        "it.",
        "fun(self: lsos.ev, format: string, ...: any)"}},
      guard<write>};
  return type;
}

}  // namespace lsos
