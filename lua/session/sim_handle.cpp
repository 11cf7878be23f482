// `sim`: an interactive simulation. Stepping and saving, and the list of all its members.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "base/bounded_file.h"
#include "base/error.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/quantity.h"
#include "lua/runtime/state.h"
#include "lua/session/sim_functions.h"

namespace lsos {

namespace {

int step(lua_State* L) {
  sim_session(L).step(luaL_optinteger(L, 2, 1));
  return 0;
}

int run_for(lua_State* L) {
  sim_session(L).run_for(check_duration_s(L, 2, "sim:run_for"));
  return 0;
}

int run_until(lua_State* L) {
  SimSession& session = sim_session(L);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  const double limit_s =
      lua_isnoneornil(L, 3) ? 366 * 86400.0 : check_duration_s(L, 3, "sim:run_until");
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
  sim_session(L).run();
  return 0;
}

int step_phase(lua_State* L) {
  sim_session(L).step_phase();
  return 0;
}

int save(lua_State* L) {
  const std::filesystem::path file = luaL_checkstring(L, 2);
  check_replaceable(file, SimSession::saved_mark);
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  write_file(file, sim_session(L).save());
  return 0;
}

int load_saved(lua_State* L) {
  const std::string file = luaL_checkstring(L, 2);
  FileBounds bounds;
  bounds.may_be_pipe = true;
  const Parsed<std::string> bytes = read_bounded(file, bounds);
  if (!bytes) throw std::runtime_error(fmt::format("{} {}", file, bytes.why));
  try {
    sim_session(L).load(*bytes.value);
  } catch (const InputError& error) {
    throw std::runtime_error(fmt::format("{} {}", file, error.what()));
  }
  return 0;
}

int reload(lua_State* L) {
  sim_session(L).reload();
  return 0;
}

}  // namespace

ScriptInstance sim_number(lua_State* L) { return handle_id(L, sim_handle_type()); }

SimSession& sim_session(lua_State* L) {
  const ScriptInstance number = sim_number(L);
  return running_sessions(L, "sim").at(number);
}

int make_sim(lua_State* L) {
  SimSessions& sims = running_sessions(L, "lsos.sim");
  luaL_checkany(L, 1);
  const ScriptInstance number =
      lua_istable(L, 1) ? sims.open(L, 1, caller_place(L)) : sims.open(luaL_checkstring(L, 1));
  push_handle(L, sim_handle_type(), number);
  return 1;
}

const HandleType& sim_handle_type() {
  static const HandleType type{
      "sim",
      "An interactive simulation: of a scenario or the prompt. It stands still between two calls.",
      {{"time_s", guard<sim_time_s>, "number", "Since the mission's start."},
       {"is_finished", guard<sim_is_finished>, "boolean", "No event is left."},
       {"rovers", guard<sim_rovers>, "table of rover",
        "By RoverId: all that `rover` has in a phase."},
       {"events", guard<sim_events>, "list of tables",
        "`rover`, `sequence`, `type`, `label`, `status`, `reason`, `ready_s`, `start_s`, `end_s`, "
        "`distance_m`, `energy_used_j`, `solar_j`."},
       {"folder", guard<sim_folder>, "text", "Where its log is."}},
      {{"step", guard<step>, "sim:step(n)",
        "To the next exchange, n times: 0.1 s while something moves, else when something happens.",
        "fun(self: lsos.sim, n?: integer)"},
       {"run_for", guard<run_for>, "sim:run_for(duration_s)",
        "So long, or to the mission's end: seconds, or a text such as '20 min'.",
        "fun(self: lsos.sim, duration_s: number|string)"},
       {"run_until", guard<run_until>, "sim:run_until(function, limit_s)",
        "Until the function of sim answers true; false when the limit or the end came first. It is "
        "asked at each exchange, over quiet time at whole seconds.",
        "fun(self: lsos.sim, is_enough: (fun(sim: lsos.sim): any), limit_s?: number|string): "
        "boolean"},
       {"run", guard<run>, "sim:run()", "To the mission's end.", "fun(self: lsos.sim)"},
       {"step_phase", guard<step_phase>, "sim:step_phase()", "Until a rover enters another phase.",
        "fun(self: lsos.sim)"},
       {"where", guard<sim_where>, "sim:where()", "What all rovers do, as a text.",
        "fun(self: lsos.sim): string"},
       {"event", guard<sim_event>, "sim:event(name)", "The one with that label, or ROVER/SEQUENCE.",
        "fun(self: lsos.sim, name: string): table"},
       {"notes", guard<sim_notes>, "sim:notes(name)",
        "What events logged, findings, decisions: `time_s`, `rover`, `sequence`, `name`, "
        "`fields`; of that name, or all.",
        "fun(self: lsos.sim, name?: string): table[]"},
       {"picture", guard<sim_picture>, "sim:picture(file, { from = , rover = , size_px = })",
        "Draws it as it stands, as a PNG: from 'sun' (when left out), 'chase', 'east', 'above' or "
        "a "
        "rover. Answers the file: one beside the log when left out.",
        "fun(self: lsos.sim, file?: string, view?: { from?: string, rover?: string, size_px?: "
        "integer }): string"},
       {"dispatch", guard<sim_dispatch>,
        "sim:dispatch(rover_id, type, { Field = , path = , at = })",
        "One more event, after those that have begun; answers its Sequence.",
        "fun(self: lsos.sim, rover_id: string, type: string, fields?: table): integer"},
       {"save", guard<save>, "sim:save(file)", "Writes all of its state.",
        "fun(self: lsos.sim, file: string)"},
       {"load", guard<load_saved>, "sim:load(file)", "Goes back to it. The log begins anew there.",
        "fun(self: lsos.sim, file: string)"},
       {"reload", guard<reload>, "sim:reload()",
        "Reads event scripts anew: what has changed is called from the next phase on.",
        "fun(self: lsos.sim)"},
       {"shade", guard<sim_shade>, "sim:shade(rover_id, share)",
        "So much of the sunlight reaches the rover's panels, 0 to 1.",
        "fun(self: lsos.sim, rover_id: string, share: number)"},
       {"fault", guard<sim_fault>,
        "sim:fault(rover_id, { what = , part = , mode = , share = , is_repair = })",
        "Something of the rover breaks, or is repaired, as in rover:break_part.",
        "fun(self: lsos.sim, rover_id: string, breakage: { what: string, part?: string, mode?: "
        "string, share?: number, is_repair?: boolean })"},
       {"set_wheel", guard<sim_set_wheel>, "sim:set_wheel(rover_id, wheel, mode)",
        "A wheel fails: 'locked' (when left out), 'free'; or is 'driven', in any configuration.",
        "fun(self: lsos.sim, rover_id: string, wheel: string, mode?: 'locked'|'free'|'driven')"},
       {"stick_panel", guard<sim_stick_panel>, "sim:stick_panel(rover_id, panel, is_stuck)",
        "A panel (all when left out) stays as it is.",
        "fun(self: lsos.sim, rover_id: string, panel?: string, is_stuck?: boolean)"},
       {"silence", guard<sim_silence>, "sim:silence(rover_id, is_silent)",
        "The rover's antennas work for nobody.",
        "fun(self: lsos.sim, rover_id: string, is_silent?: boolean)"},
       {"set_soil", guard<sim_set_soil>, "sim:set_soil(name)", "The ground is of another soil now.",
        "fun(self: lsos.sim, name: string)"}}};
  return type;
}

}  // namespace lsos
