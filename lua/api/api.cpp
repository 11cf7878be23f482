#include "lua/api/api.h"

#include <fmt/format.h>

#include <cmath>

#include "lua/api/answer.h"
#include "lua/api/derive.h"
#include "lua/runtime/module.h"
#include "lua/runtime/read_only.h"
#include "lua/runtime/sandbox.h"
#include "lua/runtime/state.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

int vec3(lua_State* L) {
  push_vec3(L, Vec3(luaL_checknumber(L, 1), luaL_checknumber(L, 2), luaL_optnumber(L, 3, 0)));
  return 1;
}

int is_empty(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 1);
  lua_pushnil(L);
  lua_pushboolean(L, lua_next(L, 1) == 0);
  return 1;
}

int random(lua_State* L) {
  const EventCall& call = running_call(L, "lsos.random");
  const double low = luaL_optnumber(L, 1, 0), high = luaL_optnumber(L, 2, 1);
  if (!(low <= high)) throw std::runtime_error("lsos.random(low, high): low is above high");
  if (!std::isfinite(high - low)) {
    throw std::runtime_error("lsos.random(low, high): both must be finite");
  }
  if (!call.random) {
    call.random.emplace(call.phase.seed, call.phase.rover_id, call.phase.sequence,
                        fmt::format("script {}", call.phase.script_number));
  }
  lua_pushnumber(L, call.random->uniform(low, high));
  return 1;
}

// What only scenarios and prompts have, see session_api.h.
constexpr char sim_name[] = "lsos.sim", scenario_name[] = "lsos.scenario";
template <const char* name>
int refuse_outside_scenarios(lua_State*) {
  throw std::runtime_error(fmt::format("{} works only in scenarios and at the prompt", name));
}

}  // namespace

const std::vector<ApiFunction>& api_functions() {
  static const std::vector<ApiFunction> functions{
      {"fail", guard<answer_fail>, "lsos.fail(format, ...)",
       "Answer: the event has failed; the reason as string.format makes it.",
       "fun(format: string, ...: any): lsos.answer"},
      {"sleep", guard<answer_sleep>, "lsos.sleep(time_s)",
       "Answer: call this phase again after that long.", "fun(time_s: number): lsos.answer"},
      {"sleep_until", guard<answer_sleep_until>, "lsos.sleep_until(time_s)",
       "Answer: call this phase again at that time since the mission's start.",
       "fun(time_s: number): lsos.answer"},
      {"arrival_within", guard<answer_arrival_within>, "lsos.arrival_within(time_s)",
       "Answer: call this phase again when the drive has ended, or after that long.",
       "fun(time_s: number): lsos.answer"},
      {"vec3", guard<vec3>, "lsos.vec3(x, y, z)",
       "A vector with + - * / and :length(), :dot(v), :cross(v); z is 0 when left out.",
       "fun(x: number, y: number, z?: number): vec3"},
      {"random", guard<random>, "lsos.random(low, high)",
       "A uniform random number in low..high (0..1 when left out), repeatable by the plan's Seed.",
       "fun(low?: number, high?: number): number"},
      {"is_empty", guard<is_empty>, "lsos.is_empty(table)", "Whether a table has no entry.",
       "fun(table: table): boolean"},
      {"derive", guard<derive>, "lsos.derive(base, changes)",
       "In rovers/: the rover or asset of that name with changes: `{ doc = '...', battery = { "
       "capacity_j = 2e8 }, panels = { Roof = { efficiency = 0.32 } }, loads = { radio = false } "
       "}`. Its `assumptions` are added to those of the base.",
       "fun(base: string, changes: table): lsos.made"}};
  return functions;
}

const std::vector<ApiConstant>& api_constants() {
  static const std::vector<ApiConstant> constants{
      {"done", [](lua_State* L) { push_answer(L, Done{}); }, "Answer: the event is completed."},
      {"arrival", [](lua_State* L) { push_answer(L, Arrival{}); },
       "Answer: call this phase again when the drive has ended (rover.drive says how)."}};
  return constants;
}

const std::vector<ApiSection>& api_sections() {
  static const std::vector<ApiSection> sections{{"Events", event_constructors()},
                                                {"Fields of events", field_constructors()},
                                                {"Rovers", rover_constructors()},
                                                {"Terrains and soils", terrain_constructors()},
                                                {"Studies", study_constructors()}};
  return sections;
}

void make_module(lua_State* L, const std::vector<ApiFunction>& more) {
  make_sandbox(L);
  lua_newtable(L);
  for (const auto& functions : {api_functions(), more}) {
    for (const ApiFunction& entry : functions) {
      lua_pushcfunction(L, entry.function);
      lua_setfield(L, -2, entry.name);
    }
  }
  for (const ApiConstant& entry : api_constants()) {
    entry.push(L);
    lua_setfield(L, -2, entry.name);
  }
  for (const ApiSection& section : api_sections()) {
    for (const Constructor& entry : section.constructors) {
      lua_pushstring(L, entry.name);
      lua_pushcclosure(L, entry.function, 1);
      lua_setfield(L, -2, entry.name);
    }
  }
  make_read_only(L, "lsos");
  keep_lsos_module(L);
}

void make_api(lua_State* L) {
  static const std::vector<ApiFunction> refusals{
      {"sim", guard<refuse_outside_scenarios<sim_name>>, "", "", ""},
      {"scenario", guard<refuse_outside_scenarios<scenario_name>>, "", "", ""}};
  make_module(L, refusals);
}

}  // namespace lsos
