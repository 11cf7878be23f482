#include "lua/api/rover_facts.h"

#include <cmath>

#include "vehicle/footprint.h"

namespace lsos {

namespace {

void set(lua_State* L, const char* name, double value) {
  if (!std::isfinite(value)) return;
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

void set(lua_State* L, const char* name, bool value) {
  lua_pushboolean(L, value);
  lua_setfield(L, -2, name);
}

void set(lua_State* L, const char* name, const std::string& value) {
  lua_pushlstring(L, value.data(), value.size());
  lua_setfield(L, -2, name);
}

void push_panel(lua_State* L, const PanelSpec& panel) {
  lua_newtable(L);
  set(L, "name", panel.name);
  set(L, "turns", panel.can_turn());
  set(L, "is_stowable", panel.is_stowable);
  set(L, "azimuth_min_rad", panel.azimuth.least_rad);
  set(L, "azimuth_max_rad", panel.azimuth.most_rad);
  set(L, "elevation_min_rad", panel.elevation.least_rad);
  set(L, "elevation_max_rad", panel.elevation.most_rad);
}

}  // namespace

void push_rover_facts(lua_State* L, const PlanRover& rover, const RoverModel& model) {
  lua_newtable(L);
  set(L, "id", rover.id);
  set(L, "type", rover.type);
  set(L, "initial_charge", rover.initial_charge);
  set(L, "length_m",
      2 * footprint_at_rest(make_vehicle(model.spec, rover.configuration, 1)).half_m.x());
  if (model.power.battery) {
    set(L, "battery_capacity_j", model.power.battery->capacity_j);
    set(L, "generator_w", model.power.generator_w);
    set(L, "charge_power_max_w", model.power.battery->charge_power_max_w);
  }
  if (const auto crew = model.crew_of(rover.configuration)) {
    set(L, "crew", static_cast<double>(*crew));
  }
  if (model.heights) {
    set(L, "height_min_m", model.heights->least_m);
    set(L, "height_max_m", model.heights->greatest_m);
    set(L, "has_posture_control", std::get<Legged>(model.spec.suspension).posture.has_value());
  }
  if (!rover.configuration.empty()) set(L, "configuration", rover.configuration);
  if (model.limits.slope_max_rad) set(L, "slope_max_rad", *model.limits.slope_max_rad);
  lua_newtable(L);
  lua_Integer count = 0;
  for (const PanelSpec& panel : model.power.panels) {
    push_panel(L, panel);
    lua_rawseti(L, -2, ++count);
  }
  lua_setfield(L, -2, "panels");
}

}  // namespace lsos
