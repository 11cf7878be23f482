#include "lua/session/session_api.h"

#include "lua/runtime/state.h"
#include "lua/session/scenario.h"
#include "lua/session/sim_sessions.h"

namespace lsos {

const std::vector<ApiFunction>& session_functions() {
  static const std::vector<ApiFunction> functions{
      {"sim", guard<make_sim>, "lsos.sim(plan)",
       "An interactive simulation, of a plan's file or a table: `planet`, `terrain`, "
       "`terrain_beyond`, "
       "`soil`, `start`, "
       "`seed`, `site`, `log_interval_s`, `parked_log_interval_s`, `max_duration_s`, "
       "`on_failure`, `rovers = { Id = { type = , at = , heading_deg = , config = , variant = , "
       "charge = , on_failure = , events = } }` and `assets`. In scenarios and at the prompt only.",
       "fun(plan: string|table): lsos.sim"},
      {"scenario", guard<add_scenario>, "lsos.scenario(name, function(t))",
       "One more scenario of this file; `lsos-host test` runs them.",
       "fun(name: string, scenario: fun(t: lsos.t))"}};
  return functions;
}

std::vector<ApiFunction> all_functions() {
  std::vector<ApiFunction> all = api_functions();
  all.insert(all.end(), session_functions().begin(), session_functions().end());
  return all;
}

Limits session_limits() {
  Limits limits;
  limits.instructions = 2'000'000'000;
  limits.cpu_s = 1e9;
  return limits;
}

void make_session_api(lua_State* L) { make_module(L, session_functions()); }

}  // namespace lsos
