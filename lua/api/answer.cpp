#include "lua/api/answer.h"

#include <fmt/format.h>

#include <cmath>

#include "base/utf8.h"
#include "lua/api/arguments.h"
#include "lua/runtime/constructed_value.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"

namespace lsos {

namespace {

constexpr const char* answer_kind = "answer";

// Latest time that scripts may give, s: longer than any mission, and still exact in microseconds.
constexpr double time_max_s = 9e9;

double check_time_s(lua_State* L, double min, const char* function) {
  const double time_s = luaL_checknumber(L, 1);
  if (time_s >= min && time_s <= time_max_s) return time_s;
  throw std::runtime_error(
      fmt::format("{}({}): a time of {}..{:g} s is wanted", function, time_s, min, time_max_s));
}

}  // namespace

void push_answer(lua_State* L, PhaseAnswer answer) {
  push_constructed(L, {answer_kind, {}, std::move(answer)});
}

const PhaseAnswer* to_answer(lua_State* L, int index) {
  const ConstructedValue* made = to_constructed(L, index);
  return made == nullptr ? nullptr : std::any_cast<PhaseAnswer>(&made->value);
}

std::string formatted(lua_State* L) {
  luaL_checkstring(L, 1);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_getfield(L, -1, LUA_STRLIBNAME);
  lua_getfield(L, -1, "format");
  lua_insert(L, 1);
  lua_pop(L, 2);
  lua_call(L, lua_gettop(L) - 1, 1);
  std::string text = error_text(L, -1);
  lua_settop(L, 0);
  return text;
}

int answer_fail(lua_State* L) {
  constexpr std::size_t reason_bytes_max = 4000;
  push_answer(L, Fail{beginning(formatted(L), reason_bytes_max)});
  return 1;
}

int answer_sleep(lua_State* L) {
  const EventCall& call = running_call(L, "lsos.sleep");
  const double time_s = check_time_s(L, 0, "lsos.sleep");
  push_answer(L, SleepUntil{call.phase.now + from_seconds(time_s)});
  return 1;
}

int answer_sleep_until(lua_State* L) {
  running_call(L, "lsos.sleep_until");
  push_answer(L, SleepUntil{from_seconds(check_time_s(L, -time_max_s, "lsos.sleep_until"))});
  return 1;
}

int answer_arrival_within(lua_State* L) {
  const EventCall& call = running_call(L, "lsos.arrival_within");
  const double time_s = check_time_s(L, 0, "lsos.arrival_within");
  push_answer(L, Arrival{call.phase.now + from_seconds(time_s)});
  return 1;
}

PhaseAnswer read_answer(lua_State* L, int base, const EventDeclaration& event) {
  const int count = lua_gettop(L) - base;
  if (count > 1) throw std::runtime_error(fmt::format("a phase answers one value, not {}", count));
  if (count == 0 || lua_isnil(L, -1)) return Stay{};
  if (const PhaseAnswer* answer = to_answer(L, -1)) return *answer;
  if (lua_type(L, -1) != LUA_TSTRING) {
    throw std::runtime_error(fmt::format(
        "a phase answers nothing, a phase's name, lsos.done, lsos.fail(...), lsos.sleep(s), "
        "lsos.sleep_until(s), lsos.arrival or lsos.arrival_within(s), not {}",
        describe(L, -1)));
  }
  return GoTo{find_phase(event, key_text(L, -1)).name};
}

}  // namespace lsos
