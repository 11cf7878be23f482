// `ev`: what an event was given, what it remembers, and what time it is.
#include <fmt/format.h>

#include <string>

#include "lua/api.h"
#include "lua/handle.h"
#include "lua/state.h"
#include "lua/vec3.h"

namespace lsos {

namespace {

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

constexpr const char* geometry_metatable = "lsos.geometry";

const Path3& waypoints(lua_State* L) {
  luaL_checkudata(L, 1, geometry_metatable);
  return *to_geometry(L, 1);
}

// A new vec3 each time, so that changing it changes nothing here.
int geometry_index(lua_State* L) {
  const Path3& path = waypoints(L);
  int is_whole = 0;
  const lua_Integer i = lua_tointegerx(L, 2, &is_whole);
  if (lua_type(L, 2) != LUA_TNUMBER || is_whole == 0) {
    throw std::runtime_error("ev.geometry is a list: ev.geometry[1] is the first waypoint");
  }
  if (i < 1 || static_cast<std::size_t>(i) > path.size()) {
    lua_pushnil(L);
  } else {
    push_vec3(L, path[static_cast<std::size_t>(i - 1)]);
  }
  return 1;
}

int geometry_length(lua_State* L) {
  lua_pushinteger(L, static_cast<lua_Integer>(waypoints(L).size()));
  return 1;
}

int geometry_write(lua_State*) { throw std::runtime_error("ev.geometry is read-only"); }

int geometry_pairs(lua_State*) { throw std::runtime_error("ev.geometry is a list: use ipairs"); }

}  // namespace

const Path3* to_geometry(lua_State* L, int index) {
  const auto* id = static_cast<const ScriptInstance*>(luaL_testudata(L, index, geometry_metatable));
  if (id == nullptr) return nullptr;
  const EventCall& call = running_call(L, "ev.geometry");
  if (call.instance != *id) {
    throw std::runtime_error("ev.geometry belongs to an event that is not running now");
  }
  return &call.arguments.geometry_S_m;
}

void push_geometry(lua_State* L, ScriptInstance instance) {
  auto* id = static_cast<ScriptInstance*>(lua_newuserdatauv(L, sizeof(ScriptInstance), 0));
  *id = instance;
  if (luaL_newmetatable(L, geometry_metatable) != 0) {
    constexpr luaL_Reg functions[] = {{"__index", guard<geometry_index>},
                                      {"__len", guard<geometry_length>},
                                      {"__newindex", guard<geometry_write>},
                                      {"__pairs", guard<geometry_pairs>},
                                      {nullptr, nullptr}};
    luaL_setfuncs(L, functions, 0);
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
  }
  lua_setmetatable(L, -2);
}

const HandleType& event_handle_type() {
  static const HandleType type{
      "ev",
      "The event that runs.",
      {{"params", params, "table", "The plan's fields by script key, SI, read-only."},
       {"geometry", geometry, "list of vec3", "Waypoints in the site frame, m, read-only."},
       {"state", state, "table", "What the event remembers; all that lives between two calls."},
       {"label", label, "text", "The event's name in the plan."},
       {"sequence", sequence, "integer", "Its Sequence in the plan."},
       {"time_s", time_s, "number", "Now, since the mission's start."},
       {"elapsed_s", elapsed_s, "number", "Since the event's first phase began."},
       {"phase_elapsed_s", phase_elapsed_s, "number", "Since this phase began."}},
      {{"log", guard<log>, "ev:log(name, fields)",
        "Writes a row into the log's notes; fields is a table of plain values or nil.",
        "fun(self: lsos.ev, name: string, fields?: table)"}},
      guard<write>};
  return type;
}

}  // namespace lsos
