#include "lua/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/units.h"
#include "lua/sandbox.h"
#include "lua/state.h"

namespace lsos {

namespace {

struct Quantity {
  const char* name;
  double (*of)(const SampleRow&);
  const char* doc;
};

const std::vector<Quantity>& quantities() {
  using R = const SampleRow&;
  static const std::vector<Quantity> list{
      {"time_s", [](R r) { return seconds(r.time); }, "since the mission's start"},
      {"lon_deg", [](R r) { return lon_deg(r.place); }, "of the rover"},
      {"lat_deg", [](R r) { return lat_deg(r.place); }, "of the rover"},
      {"elevation_m", [](R r) { return r.elevation_m; }, "of the ground under it"},
      {"x_m", [](R r) { return r.p_S_m.x(); }, "east in the site's frame"},
      {"y_m", [](R r) { return r.p_S_m.y(); }, "north"},
      {"z_m", [](R r) { return r.p_S_m.z(); }, "up"},
      {"roll_rad", [](R r) { return r.roll_rad; }, "right side down positive"},
      {"pitch_rad", [](R r) { return r.pitch_rad; }, "nose up positive"},
      {"heading_rad", [](R r) { return r.heading_rad; }, "clockwise from true north"},
      {"speed_mps", [](R r) { return r.speed_mps; }, "along the ground"},
      {"distance_m", [](R r) { return r.distance_m; }, "driven since the start"},
      {"slope_rad", [](R r) { return r.slope_rad; }, "of the ground under the wheels"},
      {"slip", [](R r) { return r.slip; }, "mean over driven wheels"},
      {"slip_max", [](R r) { return r.slip_max; }, "of the wheel that slips most"},
      {"sinkage_m", [](R r) { return r.sinkage_m; }, "mean over wheels"},
      {"energy_j", [](R r) { return r.energy_j; }, "in the battery"},
      {"charge", [](R r) { return r.charge; }, "of the battery, 0 to 1"},
      {"energy_rate_w", [](R r) { return r.energy_rate_w; }, "into the battery"},
      {"solar_w", [](R r) { return r.solar_w; }, "that is used"},
      {"solar_available_w", [](R r) { return r.solar_available_w; }, "that the panels could give"},
      {"external_w", [](R r) { return r.external_w; }, "from outside"},
      {"load_w", [](R r) { return r.load_w; }, "of all but driving"},
      {"drive_w", [](R r) { return r.drive_w; }, "of the wheel motors"},
      {"loss_w", [](R r) { return r.loss_w; }, "of charging and discharging"},
      {"solar_j", [](R r) { return r.solar_j; }, "since the start"},
      {"external_j", [](R r) { return r.external_j; }, "since the start"},
      {"load_j", [](R r) { return r.load_j; }, "since the start"},
      {"drive_j", [](R r) { return r.drive_j; }, "since the start"},
      {"loss_j", [](R r) { return r.loss_j; }, "since the start"},
      {"sun_fraction", [](R r) { return r.sun_fraction; }, "of its panels that the Sun sees"},
      {"incidence", [](R r) { return r.incidence; }, "the same times the cosine"}};
  return list;
}

constexpr std::array<ConditionName, 4> questions{
    {{"distance_to", "distance_to(id): m, to another rover or an asset"},
     {"sees", "sees(id): its antenna sees that of another rover, of an asset, or 'Earth'"},
     {"is_linked_to", "is_linked_to(id): the same, in range, and both antennas up"},
     {"resource", "resource(name): what is left of it"}}};

// Upvalue 1 of the functions: the rover.
const RoverPort& rover_of(lua_State* L) {
  return *static_cast<const RoverPort*>(lua_touserdata(L, lua_upvalueindex(1)));
}

int distance_to(lua_State* L) {
  const RoverPort& rover = rover_of(L);
  const std::string id = luaL_checkstring(L, 1);
  const auto p_S_m = rover.place_of_S_m(id);
  if (!p_S_m) throw std::runtime_error(fmt::format("there is no rover or asset '{}'", id));
  lua_pushnumber(L, (*p_S_m - rover.view().p_S_m).norm());
  return 1;
}

template <auto member>
int sight_of(lua_State* L) {
  const auto sight = rover_of(L).sight_of(luaL_checkstring(L, 1));
  lua_pushboolean(L, sight && (*sight).*member);
  return 1;
}

int resource(lua_State* L) {
  auto& rover = const_cast<RoverPort&>(rover_of(L));  // asks only
  lua_pushnumber(L, rover.power().resource(luaL_checkstring(L, 1)).value_or(std::nan("")));
  return 1;
}

// Pushes the table of what a condition can name.
void push_names(lua_State* L, const SampleRow& row, const RoverPort& rover) {
  push_environment(L);
  for (const Quantity& quantity : quantities()) {
    lua_pushstring(L, quantity.name);
    lua_pushnumber(L, quantity.of(row));
    lua_rawset(L, -3);
  }
  const auto add = [&](const char* name, lua_CFunction function) {
    lua_pushstring(L, name);
    lua_pushlightuserdata(L, const_cast<RoverPort*>(&rover));
    lua_pushcclosure(L, function, 1);
    lua_rawset(L, -3);
  };
  add("distance_to", guard<distance_to>);
  add("sees", guard<sight_of<&PairSight::is_visible>>);
  add("is_linked_to", guard<sight_of<&PairSight::is_linked>>);
  add("resource", guard<resource>);
}

// Pushes the function; answers what is wrong with the text instead. On lines of its own, so that a
// comment in it ends.
std::string push_function(lua_State* L, const std::string& text) {
  const auto failure = load_text(L, "return (\n" + text + "\n)", "condition");
  if (!failure) return "";
  const auto [place, what] = split_place(failure->message, "condition");
  return what;
}

// A word of the expression that stands for something, and the text that it is called with.
struct Name {
  std::string word;
  std::string text;  // "SEV2" of distance_to('SEV2'); "" when there is none
};

// Words outside texts that are no members, without a grammar: what Lua accepts is checked by Lua.
std::vector<Name> names_in(const std::string& text) {
  std::vector<Name> names;
  const auto is_letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  char before = ' ';
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '\'' || c == '"') {
      const std::size_t begin = ++i;
      while (i < text.size() && text[i] != c) i += text[i] == '\\' ? 2 : 1;
      const bool is_argument = !names.empty() && (before == '(' || is_letter(before));
      if (is_argument && names.back().text.empty()) {
        names.back().text = text.substr(begin, i - begin);
      }
      ++i;
      before = c;
    } else if (is_letter(c)) {
      const std::size_t begin = i;
      while (i < text.size() && (is_letter(text[i]) || text[i] == '.')) ++i;
      const std::string word = text.substr(begin, i - begin);
      const bool is_number = std::isdigit(static_cast<unsigned char>(c)) != 0;
      if (!is_number && before != '.' && before != ':') {
        names.push_back({word.substr(0, word.find('.')), ""});
      }
      before = text[i - 1];
    } else {
      if (std::isspace(static_cast<unsigned char>(c)) == 0) before = c;
      ++i;
    }
  }
  return names;
}

}  // namespace

const std::vector<ConditionName>& condition_names() {
  static const std::vector<ConditionName> names = [] {
    std::vector<ConditionName> all;
    for (const Quantity& quantity : quantities()) all.push_back({quantity.name, quantity.doc});
    all.insert(all.end(), questions.begin(), questions.end());
    return all;
  }();
  return names;
}

std::string condition_fault(lua_State* L, const std::string& text,
                            const std::set<std::string>& ids) {
  static const std::set<std::string> words{"and", "or", "not", "true", "false", "math"};
  std::vector<std::string> known;
  for (const ConditionName& name : condition_names()) known.emplace_back(name.name);
  for (const Name& name : names_in(text)) {
    if (words.contains(name.word)) continue;
    if (std::ranges::find(known, name.word) == known.end()) {
      std::string hint = did_you_mean(name.word, known);
      if (hint.empty()) hint = "; see lua/README.md, Conditions";
      return fmt::format("a condition has no '{}'{}", name.word, hint);
    }
    const bool is_of_other =
        name.word == "distance_to" || name.word == "sees" || name.word == "is_linked_to";
    if (is_of_other && !name.text.empty() && !ids.contains(name.text)) {
      return fmt::format("there is no rover or asset '{}'{}", name.text,
                         did_you_mean(name.text, std::vector<std::string>(ids.begin(), ids.end())));
    }
  }
  std::string fault = push_function(L, text);
  if (fault.empty()) lua_pop(L, 1);
  return fault;
}

bool condition_holds(lua_State* L, const std::string& text, const SampleRow& row,
                     const RoverPort& rover) {
  const int top = lua_gettop(L);
  const std::string fault = push_function(L, text);
  if (!fault.empty()) throw std::runtime_error(fault);
  push_names(L, row, rover);
  lua_setupvalue(L, -2, 1);  // _ENV
  if (const auto failure = call_script(L, 0, 1)) throw std::runtime_error(failure->message);
  if (lua_type(L, -1) != LUA_TBOOLEAN) {
    const std::string found = luaL_typename(L, -1);
    lua_settop(L, top);
    throw std::runtime_error(fmt::format("gives a {}; true or false is wanted", found));
  }
  const bool holds = lua_toboolean(L, -1) != 0;
  lua_settop(L, top);
  return holds;
}

}  // namespace lsos
