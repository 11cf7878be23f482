#include "lua/session/scenario.h"

#include <fmt/format.h>

#include <cmath>

#include "lua/runtime/handle.h"
#include "lua/runtime/quantity.h"
#include "lua/runtime/state.h"
#include "lua/session/shown_value.h"
#include "lua/session/sim_sessions.h"

namespace lsos {

namespace {

constexpr int scenario_depth_max = 16;  // of tables that are compared

// Equality by value: tables are equal when all their entries are.
bool are_equal(lua_State* L, int a, int b, int depth = 0) {
  luaL_checkstack(L, 8, "tables in tables");
  a = lua_absindex(L, a);
  b = lua_absindex(L, b);
  if (lua_compare(L, a, b, LUA_OPEQ) != 0) return true;
  if (!lua_istable(L, a) || !lua_istable(L, b) || depth >= scenario_depth_max) return false;
  const auto holds = [&](int all, int of) {
    for (lua_pushnil(L); lua_next(L, all) != 0; lua_pop(L, 1)) {
      lua_pushvalue(L, -2);
      lua_rawget(L, of);
      const bool is_same = are_equal(L, -1, -2, depth + 1);
      lua_pop(L, 1);
      if (!is_same) {
        lua_pop(L, 2);
        return false;
      }
    }
    return true;
  };
  return holds(a, b) && holds(b, a);
}

// Fails an expectation: the message is `text`, after "distance: " for the text at `what` and before
// ", at 94.2 s" for the simulated time.
[[noreturn]] void fail(lua_State* L, int what, const std::string& text) {
  std::string message;
  if (lua_type(L, what) == LUA_TSTRING) message = std::string(lua_tostring(L, what)) + ": ";
  message += text;
  SimSessions& sims = running_sessions(L, "t");
  if (SimSession* sim = sims.last()) message += fmt::format(", at {} s", seconds(sim->now()));
  // The failure counts even if the script catches the error.
  sims.expectation_failed(to_string({Severity::error, caller_place(L), message}));
  throw std::runtime_error(message);
}

int expect_equal(lua_State* L) {
  handle_id(L, scenario_handle_type());
  luaL_checkany(L, 3);
  lua_settop(L, 4);
  if (are_equal(L, 2, 3)) return 0;
  std::string wanted = written_value(L, 3), found = written_value(L, 2);
  if (wanted == found && lua_type(L, 2) == LUA_TNUMBER) {
    wanted = fmt::format("{:.17g}", lua_tonumber(L, 3));
    found = fmt::format("{:.17g}", lua_tonumber(L, 2));
  }
  fail(L, 4, fmt::format("expected {}, found {}", wanted, found));
}

int expect_true(lua_State* L) {
  handle_id(L, scenario_handle_type());
  luaL_checkany(L, 2);
  lua_settop(L, 3);
  if (lua_type(L, 2) == LUA_TSTRING) {
    throw std::runtime_error(fmt::format(
        "t:check: true or false is wanted, found the text '{}', which is always true; a comparison "
        "is written without quotes",
        lua_tostring(L, 2)));
  }
  if (lua_toboolean(L, 2) != 0) return 0;
  fail(L, 3, fmt::format("expected true, found {}", written_value(L, 2)));
}

int expect_near(lua_State* L) {
  handle_id(L, scenario_handle_type());
  lua_settop(L, 5);
  const GivenQuantity wanted = check_quantity(L, 3), within = check_quantity(L, 4);
  if (wanted.unit != nullptr && within.unit != nullptr && wanted.unit->kind != within.unit->kind) {
    throw std::runtime_error(fmt::format("t:near: '{}' is a {}, '{}' a {}", wanted.unit->symbol,
                                         wanted.unit->kind, within.unit->symbol,
                                         within.unit->kind));
  }
  if (lua_type(L, 2) == LUA_TNUMBER &&
      std::abs(lua_tonumber(L, 2) - wanted.value_si) <= within.value_si) {
    return 0;
  }
  const auto shown = [](double value_si, const Unit* unit) {
    return unit == nullptr ? fmt::format("{:.9g}", value_si)
                           : fmt::format("{:.6g} {}", value_si / unit->si_factor, unit->symbol);
  };
  const std::string found =
      lua_type(L, 2) == LUA_TNUMBER ? shown(lua_tonumber(L, 2), wanted.unit) : written_value(L, 2);
  fail(L, 5,
       fmt::format("expected {} within {}, found {}", shown(wanted.value_si, wanted.unit),
                   shown(within.value_si, within.unit), found));
}

int expect_failure(lua_State* L) {
  handle_id(L, scenario_handle_type());
  luaL_checktype(L, 2, LUA_TFUNCTION);
  const std::string wanted = luaL_checkstring(L, 3);
  lua_settop(L, 4);
  lua_pushvalue(L, 2);
  if (lua_pcall(L, 0, 0, 0) == LUA_OK) {
    fail(L, 4, fmt::format("expected an error with '{}', found none", wanted));
  }
  const std::string found = error_text(L, -1);
  if (found.find(wanted) != std::string::npos) {
    running_sessions(L, "t").forget_expectation();  // this failure was expected
    return 0;
  }
  fail(L, 4, fmt::format("expected an error with '{}', found '{}'", wanted, found));
}

}  // namespace

void push_scenarios(lua_State* L) { luaL_getsubtable(L, LUA_REGISTRYINDEX, "lsos.scenarios"); }

int add_scenario(lua_State* L) {
  if (!running_sessions(L, "lsos.scenario").is_loading()) {
    throw std::runtime_error("lsos.scenario works only while a file of scenarios loads");
  }
  luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  push_scenarios(L);
  lua_newtable(L);
  lua_pushvalue(L, 1);
  lua_rawseti(L, -2, 1);
  lua_pushvalue(L, 2);
  lua_rawseti(L, -2, 2);
  lua_rawseti(L, -2, static_cast<lua_Integer>(lua_rawlen(L, -2)) + 1);
  return 0;
}

const HandleType& scenario_handle_type() {
  static const HandleType type{
      "t",
      "What a scenario says its expectations to. One that does not hold ends the scenario; `what` "
      "is shown with it. Quantities are numbers in SI units, or texts with a unit: '200 m'.",
      {},
      {{"equal", guard<expect_equal>, "t:equal(found, wanted, what)", "The two are equal.",
        "fun(self: lsos.t, found: any, wanted: any, what?: string)"},
       {"near", guard<expect_near>, "t:near(found, wanted, within, what)",
        "The number found is not farther from that than this.",
        "fun(self: lsos.t, found: number, wanted: number|string, within: number|string, what?: "
        "string)"},
       {"check", guard<expect_true>, "t:check(condition, what)", "It is true.",
        "fun(self: lsos.t, condition: any, what?: string)"},
       {"fails", guard<expect_failure>, "t:fails(function, text, what)",
        "It raises an error that has this text in it.",
        "fun(self: lsos.t, fails: fun(), text: string, what?: string)"}}};
  return type;
}

}  // namespace lsos
