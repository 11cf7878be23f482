#include "lua/host/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "lua/runtime/environment.h"
#include "lua/runtime/state.h"
#include "record/quantities.h"

namespace lsos {

namespace {

// Quantities of its row that are no members of it, and those that mean something else here than in
// the log.
struct OwnQuantity {
  const char* name;
  double (*of)(const SampleRow&);
  const char* doc;
};

constexpr std::array own_quantities{
    OwnQuantity{"time_s", [](const SampleRow& r) { return seconds(r.time); },
                "since the mission's start"},
    OwnQuantity{"lon_deg", [](const SampleRow& r) { return lon_deg(r.place); }, "of the rover"},
    OwnQuantity{"lat_deg", [](const SampleRow& r) { return lat_deg(r.place); }, "of the rover"},
    OwnQuantity{"x_m", [](const SampleRow& r) { return r.p_S_m.x(); }, "east in the site's frame"},
    OwnQuantity{"y_m", [](const SampleRow& r) { return r.p_S_m.y(); }, "north"},
    OwnQuantity{"z_m", [](const SampleRow& r) { return r.p_S_m.z(); }, "up"},
    OwnQuantity{"slip", [](const SampleRow& r) { return r.slip; },
                "of driving: mean over driven wheels and the last second"},
    OwnQuantity{"slip_max", [](const SampleRow& r) { return r.slip_max; },
                "the same of the wheel that slips most"},
};

// A quantity that a condition can name: one of its own, or of the register.
struct ConditionQuantity {
  const char* name;
  const char* doc;
  double (*own)(const SampleRow&);
  double SampleRow::*logged;

  double of(const SampleRow& row) const { return own != nullptr ? own(row) : row.*logged; }
};

const std::vector<ConditionQuantity>& condition_quantities() {
  static const std::vector<ConditionQuantity> list = [] {
    std::vector<ConditionQuantity> all;
    for (const OwnQuantity& own : own_quantities) {
      all.push_back({own.name, own.doc, own.of, nullptr});
    }
    for (const Quantity& quantity : quantities()) {
      const auto is_own = [&](const OwnQuantity& own) { return quantity.name == own.name; };
      if (std::ranges::any_of(own_quantities, is_own)) continue;
      all.push_back({quantity.name.data(), quantity.meaning.data(), nullptr, quantity.value});
    }
    return all;
  }();
  return list;
}

constexpr std::array<ConditionName, 4> questions{
    {{"distance_to", "distance_to(id): m, to another rover or an asset"},
     {"sees", "sees(id): its antenna sees that of another rover, of an asset, or 'Earth'"},
     {"is_linked_to", "is_linked_to(id): the same, in range, and both antennas up"},
     {"resource", "resource(name): what is left of it"}}};

// A condition is compiled whenever it is asked, which is each second while an event waits for it.
constexpr std::size_t condition_bytes_max = 4000;
constexpr double share_of_call = 0.01;  // of a call's budgets, enough for an expression

// Upvalue 1 of the functions: the rover.
const RoverPort& condition_rover(lua_State* L) {
  return *static_cast<const RoverPort*>(lua_touserdata(L, lua_upvalueindex(1)));
}

int distance_to(lua_State* L) {
  const RoverPort& rover = condition_rover(L);
  const std::string id = luaL_checkstring(L, 1);
  const auto p_S_m = rover.place_of_S_m(id);
  if (!p_S_m) throw std::runtime_error(fmt::format("there is no rover or asset '{}'", id));
  lua_pushnumber(L, (*p_S_m - rover.view().p_S_m).norm());
  return 1;
}

template <auto member>
int condition_sight(lua_State* L) {
  const auto sight = condition_rover(L).sight_of(luaL_checkstring(L, 1));
  lua_pushboolean(L, sight && (*sight).*member);
  return 1;
}

int resource(lua_State* L) {
  auto& rover = const_cast<RoverPort&>(condition_rover(L));  // only reads
  lua_pushnumber(L, rover.power().resource(luaL_checkstring(L, 1)).value_or(std::nan("")));
  return 1;
}

// Pushes the environment with all names that a condition can use. `rover`: nullptr: questions are
// none of them.
void push_names(lua_State* L, const SampleRow& row, const RoverPort* rover) {
  push_environment(L);
  for (const ConditionQuantity& quantity : condition_quantities()) {
    lua_pushstring(L, quantity.name);
    lua_pushnumber(L, quantity.of(row));
    lua_rawset(L, -3);
  }
  if (rover == nullptr) return;
  const auto add = [&](const char* name, lua_CFunction function) {
    lua_pushstring(L, name);
    lua_pushlightuserdata(L, const_cast<RoverPort*>(rover));
    lua_pushcclosure(L, function, 1);
    lua_rawset(L, -3);
  };
  add("distance_to", guard<distance_to>);
  add("sees", guard<condition_sight<&PairSight::is_visible>>);
  add("is_linked_to", guard<condition_sight<&PairSight::is_linked>>);
  add("resource", guard<resource>);
}

// Compiles the condition and pushes its function, or returns what is wrong with the text. The text
// is put on separate lines, so that a comment in it ends.
std::string push_function(lua_State* L, const std::string& text) {
  if (text.size() > condition_bytes_max) {
    return fmt::format("it has {} characters; a condition may have {}", text.size(),
                       condition_bytes_max);
  }
  const auto failure = load_text(L, "return (\n" + text + "\n)", "condition");
  if (!failure) {
    // "a) or (b" compiles inside the added parentheses, but is no expression.
    if (load_text(L, "return\n" + text + "\n", "condition")) {
      lua_pop(L, 1);
      return "it is not one expression: a parenthesis closes that was not opened";
    }
    lua_pop(L, 1);
    return "";
  }
  std::string what = split_place(failure->message, "condition").second;
  // The parenthesis was added here, so the message must not mention it.
  const std::string ours = "')' expected (to close '(' at line 1)";
  if (const auto at = what.find(ours); at != std::string::npos) {
    what.replace(at, ours.size(), "the condition cannot go on");
  }
  if (what.ends_with("near '='")) return what + "; '==' compares";
  if (what.ends_with("near ','")) return what + "; a decimal number has a point";
  if (what.ends_with("near '!'")) return what + "; 'not' turns round, '~=' is unequal";
  if (text.find('%') != std::string::npos) return what + "; a share is from 0 to 1: 80 % is 0.8";
  const bool has_number = text.find_first_of("0123456789") != std::string::npos;
  return what + (has_number ? "; numbers are in SI units and have none written, words are 'and', "
                              "'or', 'not'"
                            : "; words are 'and', 'or', 'not'");
}

// Message of the failed call, without its place: the line belongs to the text added here.
std::string cause_of(const LuaFailure& failure) {
  return split_place(failure.message, "condition").second;
}

// Calls and pops the function at the top, whose environment is set. Returns what is wrong with its
// result.
std::string call_fault(lua_State* L, bool* holds) {
  const int top = lua_gettop(L) - 1;
  if (const auto failure = call_script(L, 0, 1, share_of_call)) return cause_of(*failure);
  const bool is_answer = lua_type(L, -1) == LUA_TBOOLEAN;
  const std::string found = luaL_typename(L, -1);
  if (holds != nullptr) *holds = lua_toboolean(L, -1) != 0;
  lua_settop(L, top);
  return is_answer ? "" : fmt::format("gives a {}; true or false is wanted", found);
}

// Upvalue 1: the answer to a question in a trial.
int trial_answer(lua_State* L) {
  luaL_checkstring(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  return 1;
}

}  // namespace

const std::vector<ConditionName>& condition_names() {
  static const std::vector<ConditionName> names = [] {
    std::vector<ConditionName> all;
    for (const ConditionQuantity& quantity : condition_quantities()) {
      all.push_back({quantity.name, quantity.doc});
    }
    all.insert(all.end(), questions.begin(), questions.end());
    return all;
  }();
  return names;
}

std::optional<double> condition_quantity(const std::string& name, const SampleRow& row) {
  const auto found = std::ranges::find_if(
      condition_quantities(), [&](const ConditionQuantity& q) { return name == q.name; });
  return found == condition_quantities().end() ? std::nullopt : std::optional(found->of(row));
}

bool is_question(const std::string& name) {
  return std::ranges::any_of(questions, [&](const ConditionName& q) { return name == q.name; });
}

bool gives_number(const std::string& question) {
  return question == "distance_to" || question == "resource";
}

std::string condition_syntax_fault(lua_State* L, const std::string& text) {
  std::string fault = push_function(L, text);
  if (fault.empty()) lua_pop(L, 1);
  return fault;
}

std::string math_fault(lua_State* L, const std::string& member) {
  const auto failure = load_text(L, "return math." + member, "condition");
  if (failure) return cause_of(*failure);
  push_environment(L);
  lua_setupvalue(L, -2, 1);  // _ENV
  if (const auto missing = call_script(L, 0, 0)) return cause_of(*missing);
  return "";
}

std::string condition_trial_fault(lua_State* L, const std::string& text, double value,
                                  bool answer) {
  std::string fault = push_function(L, text);
  if (!fault.empty()) return fault;
  push_environment(L);
  const auto set = [&](const char* name, const auto& push) {
    lua_pushstring(L, name);
    push();
    lua_rawset(L, -3);
  };
  for (const ConditionQuantity& quantity : condition_quantities()) {
    set(quantity.name, [&] { lua_pushnumber(L, value); });
  }
  for (const ConditionName& question : questions) {
    set(question.name, [&] {
      if (gives_number(question.name)) {
        lua_pushnumber(L, value);
      } else {
        lua_pushboolean(L, answer);
      }
      lua_pushcclosure(L, guard<trial_answer>, 1);
    });
  }
  lua_setupvalue(L, -2, 1);  // _ENV
  return call_fault(L, nullptr);
}

namespace {

bool holds_with(lua_State* L, const std::string& text, const SampleRow& row,
                const RoverPort* rover) {
  std::string fault = push_function(L, text);
  bool holds = false;
  if (fault.empty()) {
    push_names(L, row, rover);
    lua_setupvalue(L, -2, 1);  // _ENV
    fault = call_fault(L, &holds);
  }
  if (!fault.empty()) throw std::runtime_error(fault);
  return holds;
}

}  // namespace

bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row,
                     const RoverPort& rover) {
  return holds_with(L, text, row, &rover);
}

bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row) {
  return holds_with(L, text, row, nullptr);
}

}  // namespace lsos
