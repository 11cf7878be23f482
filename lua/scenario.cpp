#include "lua/scenario.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <set>

#include "lua/console.h"
#include "lua/handle.h"
#include "lua/loader.h"
#include "lua/quantity.h"
#include "lua/sandbox.h"
#include "lua/shown_value.h"
#include "lua/sims.h"
#include "lua/state.h"
#include "product/files.h"

namespace lsos {

namespace {

constexpr const char* scenarios_key = "lsos.scenarios";   // list of { name, function }
constexpr std::int64_t instructions_max = 2'000'000'000;  // some 20 s
constexpr int depth_max = 16;                             // of tables that are compared

// Tables are equal when all that they hold is.
bool are_equal(lua_State* L, int a, int b, int depth = 0) {
  luaL_checkstack(L, 8, "tables in tables");
  a = lua_absindex(L, a);
  b = lua_absindex(L, b);
  if (lua_compare(L, a, b, LUA_OPEQ) != 0) return true;
  if (!lua_istable(L, a) || !lua_istable(L, b) || depth >= depth_max) return false;
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

// "distance: " and " (at 94.2 s of sim1)" about what is wrong.
[[noreturn]] void fail(lua_State* L, int what, const std::string& text) {
  std::string message;
  if (lua_type(L, what) == LUA_TSTRING) message = std::string(lua_tostring(L, what)) + ": ";
  message += text;
  Sims& sims = running_sims(L, "t");
  if (SimSession* sim = sims.last()) message += fmt::format(", at {} s", seconds(sim->now()));
  // It counts though the script may catch it.
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
  const Quantity wanted = check_quantity(L, 3), within = check_quantity(L, 4);
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
    running_sims(L, "t").forget_expectation();  // that one was to fail
    return 0;
  }
  fail(L, 4, fmt::format("expected an error with '{}', found '{}'", wanted, found));
}

// Pops a scenario's function and runs it.
ScenarioResult run_one(lua_State* L, Sims& sims, const std::string& file, const std::string& name,
                       const std::string& folder) {
  ScenarioResult result{file, name, "", folder, 0};
  const auto begin = std::chrono::steady_clock::now();
  push_handle(L, scenario_handle_type(), 0);
  try {
    if (const auto failure = call_script(L, 1, 0)) {
      result.failure = failure->message;
      // Where it came through, when that is more than the scenario itself.
      if (std::ranges::count(failure->traceback, '\n') > 4) {
        result.failure += "\n" + failure->traceback;
      }
      // An event that broke is what most of them fail of.
      for (const std::string& news : sims.take_news()) result.failure += "\n" + news;
    }
  } catch (const std::exception& error) {
    result.failure = fmt::format("fault inside the program: {}", error.what());
  }
  if (result.failure.empty()) result.failure = sims.failed_expectation();
  sims.close_all();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  result.wall_s = wall.count();
  std::error_code ignored;
  if (result.failure.empty()) std::filesystem::remove_all(folder, ignored);
  if (!std::filesystem::exists(folder, ignored)) result.log.clear();
  return result;
}

// Of a name, what can be a folder's; no two of a file have the same.
std::string folder_name(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t longest = 80;
  std::string text;
  for (const char c : name.substr(0, longest)) {
    text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  if (text.empty()) text = "_";
  std::string own = text;
  for (int k = 2; !taken.insert(own).second; ++k) own = fmt::format("{}_{}", text, k);
  return own;
}

}  // namespace

int add_scenario(lua_State* L) {
  if (!running_sims(L, "lsos.scenario").is_loading()) {
    throw std::runtime_error("lsos.scenario works only while a file of scenarios loads");
  }
  luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, scenarios_key);
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

void run_scenarios(const std::string& file, const std::string& filter, const std::string& folder,
                   const std::function<void(const ScenarioResult&)>& report) {
  const std::filesystem::path path = file;
  Script script;
  script.name = path.stem();
  script.file = file;
  script.folder = path.parent_path();
  const auto source = read_file(file);
  if (!source) return report({file, "", file + ": cannot be read", "", 0});
  script.source = *source;

  Limits limits;
  limits.instructions = instructions_max;
  limits.cpu_s = 1e9;
  LuaState lua(limits);
  lua.run([&](lua_State* L) {
    // On standard error: standard output is the report.
    const auto say = [](const std::string& line) { print_message("{}\n", line); };
    Sims at_load(folder, say, true);
    lua.context().in_hand = &at_load;
    Faults faults;
    if (!run_script(L, script, faults)) {
      std::string text;
      for (const Fault& fault : faults.sorted()) text += to_string(fault) + "\n";
      return report({file, "", text, "", 0});
    }
    lua_settop(L, 0);
    luaL_getsubtable(L, LUA_REGISTRYINDEX, scenarios_key);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, 1));
    if (count == 0) report({file, "", file + ": has no lsos.scenario(name, function)", "", 0});
    std::set<std::string> folders;
    for (lua_Integer k = 1; k <= count; ++k) {
      lua_settop(L, 1);
      lua_rawgeti(L, 1, k);
      lua_rawgeti(L, 2, 1);
      const std::string name = error_text(L, 3);
      if (name.find(filter) == std::string::npos && file.find(filter) == std::string::npos)
        continue;
      lua_rawgeti(L, 2, 2);
      const std::string own_folder = folder + "/" + folder_name(name, folders);
      Sims sims(own_folder, say);
      lua.context().in_hand = &sims;
      report(run_one(L, sims, file, name, own_folder));
    }
  });
  lua.context().in_hand = nullptr;
}

}  // namespace lsos
