// `rover.battery` and `rover.panels`: a rover's energy, and the methods of scripts that change it.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "lua/runtime/handle.h"
#include "lua/runtime/quantity.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

PowerPort& battery_of(lua_State* L) { return handle_rover(L, battery_handle_type()).power(); }
PowerPort& panels_of(lua_State* L) { return handle_rover(L, panels_handle_type()).power(); }

template <auto member>
int of_battery(lua_State* L) {
  push_quantity(L, battery_of(L).view().*member);
  return 1;
}

template <auto member>
int of_panels(lua_State* L) {
  push_quantity(L, panels_of(L).view().*member);
  return 1;
}

double check_not_negative(lua_State* L, int argument, const char* what) {
  const double value = luaL_checknumber(L, argument);
  if (!(value >= 0 && std::isfinite(value))) {
    throw std::runtime_error(fmt::format("{}: {}; 0 or more is wanted", what, value));
  }
  return value;
}

double check_charge(lua_State* L, const char* what) {
  const double charge = luaL_checknumber(L, 2);
  if (charge >= 0 && charge <= 1) return charge;
  throw std::runtime_error(fmt::format("{}({}): a charge of 0..1 is wanted", what, charge));
}

int time_to_charge_s(lua_State* L) {
  PowerPort& battery = battery_of(L);
  const double time_s = battery.time_to_charge_s(check_charge(L, "battery:time_to_charge_s"));
  push_quantity(L, std::isfinite(time_s) ? time_s : not_modelled);
  return 1;
}

int await_charge(lua_State* L) {
  PowerPort& battery = battery_of(L);
  battery.await_charge(check_charge(L, "battery:await_charge"));
  return 0;
}

int set_energy(lua_State* L) {
  battery_of(L).set_energy(check_not_negative(L, 2, "battery:set_energy"));
  return 0;
}

int supply(lua_State* L) {
  battery_of(L).set_supply(check_not_negative(L, 2, "battery:supply"));
  return 0;
}

int plug_into(lua_State* L) {
  std::optional<double> power_w;
  if (!lua_isnoneornil(L, 3)) power_w = check_not_negative(L, 3, "battery:plug_into");
  const std::string why = battery_of(L).plug_into(luaL_checkstring(L, 2), power_w);
  lua_pushboolean(L, why.empty());
  if (why.empty()) return 1;
  lua_pushlstring(L, why.data(), why.size());
  return 2;
}

std::string panel_name(lua_State* L) { return luaL_optstring(L, 2, ""); }

template <bool up>
int deploy_panels(lua_State* L) {
  std::optional<double> duration_s;
  if (!lua_isnoneornil(L, 3)) duration_s = check_deploying_s(L, 3, "panels");
  const Deployment deployment = panels_of(L).deploy_panel(panel_name(L), up, duration_s);
  lua_pushnumber(L, deployment.takes_s);
  lua_pushboolean(L, deployment.moves);
  return 2;
}

int steer(lua_State* L) {
  PowerPort& power = panels_of(L);
  luaL_checktype(L, 3, LUA_TTABLE);
  Faults faults;
  TableReader t(L, 3, "panels:steer", {}, faults);
  Steering steering;
  constexpr std::pair<const char*, SteerMode> modes[] = {
      {"fixed", SteerMode::fixed}, {"point", SteerMode::point}, {"track", SteerMode::track}};
  // Sums of headings and angles are within these ranges; most numbers in degrees are not.
  constexpr Range turn{-4 * std::numbers::pi, 4 * std::numbers::pi};
  constexpr Range upright{-std::numbers::pi, std::numbers::pi};
  t.word(required, "mode", modes, steering.mode, "'track', 'point' or 'fixed'.");
  t.number(optional, "azimuth_rad", steering.angles.azimuth_rad, turn,
           "Clockwise from true north (point) or from the nose (fixed).");
  t.number(optional, "elevation_rad", steering.angles.elevation_rad, upright,
           "Above the horizon (point) or the deck (fixed).");
  t.finish();
  faults.throw_if_errors();
  power.steer_panel(panel_name(L), steering);
  return 0;
}

int misses(lua_State* L) {
  const std::vector<PanelMiss> misses = panels_of(L).panel_misses();
  lua_createtable(L, static_cast<int>(misses.size()), 0);
  lua_Integer count = 0;
  for (const PanelMiss& miss : misses) {
    lua_createtable(L, 0, 7);
    lua_pushlstring(L, miss.panel.data(), miss.panel.size());
    lua_setfield(L, -2, "panel");
    lua_pushboolean(L, miss.is_stuck ? 1 : 0);
    lua_setfield(L, -2, "is_stuck");
    for (const auto& [name, value] : {std::pair{"azimuth_rad", miss.reached.azimuth_rad},
                                      {"elevation_rad", miss.reached.elevation_rad},
                                      {"wanted_azimuth_rad", miss.wanted.azimuth_rad},
                                      {"wanted_elevation_rad", miss.wanted.elevation_rad},
                                      {"off_rad", miss.off_rad}}) {
      lua_pushnumber(L, value);
      lua_setfield(L, -2, name);
    }
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

int is_any_up(lua_State* L) {
  lua_pushboolean(L, panels_of(L).view().is_any_panel_up ? 1 : 0);
  return 1;
}

int turn_left_s(lua_State* L) {
  lua_pushnumber(L, panels_of(L).panel_turn_left_s());
  return 1;
}

}  // namespace

const HandleType& battery_handle_type() {
  using V = PowerView;
  static const HandleType type{
      "rover.battery",
      "What the rover's battery holds, and what flows.",
      {{"energy_j", of_battery<&V::energy_j>, "number", "What it holds."},
       {"capacity_j", of_battery<&V::capacity_j>, "number", "When full."},
       {"charge", of_battery<&V::charge>, "number", "Their ratio, 0 to 1."},
       {"energy_rate_w", of_battery<&V::energy_rate_w>, "number", "Into it; negative: out of it."},
       {"solar_w", of_battery<&V::solar_w>, "number", "From the panels, as far as it is used."},
       {"external_w", of_battery<&V::external_w>, "number", "From outside."},
       {"external_j", of_battery<&V::external_j>, "number", "The same, since the start."},
       {"load_w", of_battery<&V::load_w>, "number", "Used by all but the wheel motors."},
       {"generator_w", of_battery<&V::generator_w>, "number",
        "Constant power made aboard; it counts as from outside."}},
      {{"time_to_charge_s", guard<time_to_charge_s>, "battery:time_to_charge_s(charge)",
        "Until it holds that share, with what flows now; nil when it will not.",
        "fun(self: lsos.rover.battery, charge: number): number?"},
       {"await_charge", guard<await_charge>, "battery:await_charge(charge)",
        "The phase is called when it holds that share, however long it sleeps; until the event "
        "ends.",
        "fun(self: lsos.rover.battery, charge: number)"},
       {"set_energy", guard<set_energy>, "battery:set_energy(energy_j)",
        "Sets what it holds, from 0 to its capacity; anything else is an error.",
        "fun(self: lsos.rover.battery, energy_j: number)"},
       {"supply", guard<supply>, "battery:supply(power_w)",
        "Power from outside until the event ends.",
        "fun(self: lsos.rover.battery, power_w: number)"},
       {"plug_into", guard<plug_into>, "battery:plug_into(asset_id, power_w)",
        "Power from an asset within 20 m until the event ends, at most so much (default all that "
        "it "
        "has). Answers true, or false and why not.",
        "fun(self: lsos.rover.battery, asset_id: string, power_w?: number): boolean, string?"}}};
  return type;
}

const HandleType& panels_handle_type() {
  using V = PowerView;
  static const HandleType type{
      "rover.panels",
      "The rover's solar panels.",
      {{"sun_fraction", of_panels<&V::sun_fraction>, "number",
        "Share of their area that sees the Sun; nil without panels."},
       {"incidence", of_panels<&V::incidence>, "number", "The same times the cosine of incidence."},
       {"is_any_up", is_any_up, "boolean", "Whether it has a panel that is not stowed."},
       {"turn_left_s", turn_left_s, "number",
        "Until all have arrived where they turn; 0: none turns."}},
      {{"deploy", guard<deploy_panels<true>>, "panels:deploy(name, duration_s)",
        "Puts up the panel of that name (nil: all). Answers how long that takes, s, and whether "
        "any "
        "moves: false when all are up.",
        "fun(self: lsos.rover.panels, name?: string, duration_s?: number): number, boolean"},
       {"stow", guard<deploy_panels<false>>, "panels:stow(name, duration_s)",
        "Folds it away; the same.",
        "fun(self: lsos.rover.panels, name?: string, duration_s?: number): number, boolean"},
       {"steer", guard<steer>, "panels:steer(name, { mode = , azimuth_rad = , elevation_rad = })",
        "Turns it (nil: all): 'track' follows the Sun, 'point' faces an azimuth and elevation, "
        "'fixed' angles about the rover.",
        "fun(self: lsos.rover.panels, name?: string, how: { mode: 'track'|'point'|'fixed', "
        "azimuth_rad?: number, elevation_rad?: number })"},
       {"misses", guard<misses>, "panels:misses()",
        "Panels that have turned and do not face the requested direction: a limit has stopped "
        "them, or they "
        "are stuck; one that follows the Sun only when it is stuck. A list of { panel = , "
        "is_stuck = , azimuth_rad = , elevation_rad = , wanted_azimuth_rad = , "
        "wanted_elevation_rad = , off_rad = }.",
        "fun(self: lsos.rover.panels): table[]"}}};
  return type;
}

}  // namespace lsos
