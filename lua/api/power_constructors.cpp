// lsos.battery, lsos.panel, lsos.load, lsos.resource and lsos.shape.
#include "lua/api/power_constructors.h"

#include <fmt/format.h>

#include <cmath>

#include "base/rotation_from_z.h"
#include "lua/api/constructors.h"

namespace lsos {

namespace {

constexpr double pi = std::numbers::pi;
constexpr Range above_none_to_one{0, 1, true};
// More than any mission has; the log holds their sums over the longest one.
constexpr Range some_energy_j{0, 1e16, true};
constexpr Range power_w{0, 1e9};
constexpr Range amount_range{0, 1e16};

void read_battery(TableReader& t, BatterySpec& battery) {
  t.number(required, "capacity_j", battery.capacity_j, some_energy_j, "From empty to full.");
  t.number(optional, "charge_efficiency", battery.charge_efficiency, above_none_to_one,
           "Of what goes in, the share that is kept (default 1).");
  t.number(optional, "discharge_efficiency", battery.discharge_efficiency, above_none_to_one,
           "Of what is taken out, the share that arrives (default 1).");
  t.number(optional, "charge_power_max_w", battery.charge_power_max_w, positive,
           "The most that goes in (default no limit).");
  t.number(optional, "discharge_power_max_w", battery.discharge_power_max_w, positive,
           "The most that is given (default no limit).");
  t.number(optional, "reserve", battery.reserve, {0, 0.99},
           "Charge, 0 to 1, above which the mission goes on after the battery was empty "
           "(default 0).");
}

// Reads the two limits of an axis, which are given together or not at all.
void read_turn_limits(TableReader& t, const char* least, const char* most, double rest_rad,
                      const Range& range, AngleLimits& limits, const char* doc) {
  std::optional<double> from_rad, to_rad;
  t.number(optional, least, from_rad, range, doc);
  t.number(optional, most, to_rad, range, "The other end.");
  limits = {from_rad.value_or(rest_rad), to_rad.value_or(rest_rad)};
  if (t.L() == nullptr) return;
  if (from_rad.has_value() != to_rad.has_value()) {
    t.fault(fmt::format("{} without {}: an axis that turns has both ends", from_rad ? least : most,
                        from_rad ? most : least));
  } else if (limits.least_rad > limits.most_rad) {
    t.fault(fmt::format("{} = {:.6g} is above {} = {:.6g}", least, limits.least_rad, most,
                        limits.most_rad));
  } else if (rest_rad < limits.least_rad || rest_rad > limits.most_rad) {
    t.fault(
        fmt::format("at rest it stands at {:.6g} rad, outside {} and {}", rest_rad, least, most));
  }
}

void read_panel(TableReader& t, PanelSpec& panel) {
  t.text(required, "name", panel.name, "What a plan's Panel says.");
  t.vec3(required, "position_m", panel.p_B_m,
         "Of its middle, about which it turns: forward, left, up as for the chassis.");
  t.number(required, "length_m", panel.length_m, positive,
           "Along the nose when it faces straight up.");
  t.number(required, "width_m", panel.width_m, positive, "Across.");
  t.number(required, "efficiency", panel.efficiency, above_none_to_one,
           "Electrical power out of light in.");
  t.number(optional, "factor", panel.factor, fraction,
           "What dust, wiring and conversion leave (default 1).");
  t.number(optional, "azimuth_rad", panel.rest.azimuth_rad, {-pi, pi},
           "Where it faces at rest, clockwise from the nose (default 0).");
  t.number(optional, "elevation_rad", panel.rest.elevation_rad, {-pi / 2, pi},
           "The same above the deck (default pi/2: straight up).");
  read_turn_limits(t, "azimuth_min_rad", "azimuth_max_rad", panel.rest.azimuth_rad, {-pi, pi},
                   panel.azimuth,
                   "How far it turns, clockwise from the nose; -pi to pi: all round "
                   "(default: it does not turn).");
  read_turn_limits(t, "elevation_min_rad", "elevation_max_rad", panel.rest.elevation_rad,
                   {-pi / 2, pi}, panel.elevation,
                   "How far it tips, above the deck (default: it does not).");
  t.number(optional, "rate_radps", panel.rate_radps, positive,
           "How fast it turns; required when it does.");
  t.number(optional, "motor_w", panel.motor_w, power_w, "While it turns (default 0).");
  t.boolean(optional, "stowable", panel.is_stowable,
            "DeploySP and StowSP put it up and down (default false).");
  t.boolean(optional, "stowed", panel.is_stowed, "At the start (default false).");
  t.number(optional, "deploy_s", panel.deploy_s, not_negative,
           "How long that takes when an event does not say (default 0).");
  t.number(optional, "deploy_w", panel.deploy_w, power_w, "Meanwhile (default 0).");
  if (t.L() == nullptr) return;
  if (panel.can_turn() && panel.rate_radps <= 0) {
    t.fault("rate_radps is missing: a panel that turns has one");
  }
  if (panel.is_stowed && !panel.is_stowable) {
    t.fault("stowed = true, but stowable is not: nothing could ever put it up");
  }
}

void read_load(TableReader& t, LoadSpec& load) {
  constexpr std::pair<const char*, LoadState> states[] = {{"always", LoadState::always},
                                                          {"dark", LoadState::dark},
                                                          {"parked", LoadState::parked},
                                                          {"driving", LoadState::driving}};
  t.text(required, "name", load.name, "For readers.");
  t.number(required, "power_w", load.power_w, power_w, "While it is on.");
  t.word(optional, "when", states, load.when,
         "'always', 'dark' (no sunlight falls on the rover), 'parked' or 'driving' (default "
         "'always').");
}

void read_resource(TableReader& t, ResourceSpec& resource) {
  t.text(required, "name", resource.name, "What a plan's Resource says.");
  t.text(required, "unit", resource.unit, "For readers: 'kg', 'tubes'.");
  t.number(required, "amount", resource.amount, amount_range, "At the start.");
}

// Reads a colour such as '#c08040'.
bool read_colour(const std::string& text, Vec3& colour) {
  if (text.size() != 7 || text[0] != '#') return false;
  for (int k = 0; k < 3; ++k) {
    const std::string digits = text.substr(static_cast<std::size_t>(1 + 2 * k), 2);
    if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) return false;
    colour[k] = std::stoi(digits, nullptr, 16) / 255.0;
  }
  return true;
}

void read_shape(TableReader& t, Shape& shape) {
  std::optional<Vec3> size_m;
  std::optional<double> radius_m, length_m;
  Vec3 axis = Vec3::UnitZ();
  double yaw_rad = 0, pitch_rad = 0;
  std::string colour;
  t.vec3(optional, "size_m", size_m, "Of a box: length, width, height.");
  t.number(optional, "radius_m", radius_m, positive, "Of a cylinder, in place of size_m.");
  t.number(optional, "length_m", length_m, positive, "The same.");
  t.vec3(optional, "axis", axis, "Of a cylinder: forward, left, up (default straight up).");
  t.vec3(required, "position_m", shape.p_B_m, "Of its middle: forward, left, up, at rest.");
  t.number(optional, "yaw_rad", yaw_rad, any_number, "Of a box, to the left (default 0).");
  t.number(optional, "pitch_rad", pitch_rad, any_number, "Of a box, nose up (default 0).");
  t.text(optional, "part", shape.part,
         "The link that it moves with, by name (default: the chassis).");
  t.text(optional, "colour", colour, "As '#c0c0c0', red, green and blue (default light grey).");
  if (t.L() == nullptr) return;
  if (size_m.has_value() == radius_m.has_value() || radius_m.has_value() != length_m.has_value()) {
    t.fault("size_m for a box, or radius_m and length_m for a cylinder, is wanted");
    return;
  }
  if (!colour.empty() && !read_colour(colour, shape.colour)) {
    t.fault(fmt::format("colour = '{}': red, green and blue as '#c0c0c0' is wanted", colour));
  }
  if (size_m) {
    shape.size_m = *size_m;
    if (size_m->minCoeff() <= 0) t.fault("size_m: all three must be more than 0 m");
    shape.R_BL =
        (Eigen::AngleAxisd(yaw_rad, Vec3::UnitZ()) * Eigen::AngleAxisd(-pitch_rad, Vec3::UnitY()))
            .toRotationMatrix();
    return;
  }
  shape.kind = Shape::Kind::cylinder;
  shape.size_m = {2 * *radius_m, 2 * *radius_m, *length_m};
  if (axis.norm() == 0) {
    t.fault("axis: a direction is wanted, found 0, 0, 0");
  } else {
    shape.R_BL = rotation_from_z(axis);
  }
}

}  // namespace

void read_panels(TableReader& t, std::vector<PanelSpec>& panels) {
  t.list(optional, "panels", "panel", panels, "Solar panels (default none).");
  check_unique_names(t, "panels", panels);
}

void read_shapes(TableReader& t, std::vector<Shape>& shapes) {
  t.list(optional, "shapes", "shape", shapes,
         "What it looks like, and casts shadows with; wheels and what they hang on are drawn "
         "without being named "
         "(default: the chassis' box).");
}

void read_power(TableReader& t, PowerSpec& power) {
  BatterySpec battery;
  t.made(optional, "battery", "battery", battery,
         "Without one the energy balance is not modelled (default).");
  if (battery.capacity_j > 0) power.battery = battery;
  read_panels(t, power.panels);
  t.number(optional, "generator_w", power.generator_w, power_w,
           "Constant electrical power made aboard, as of a radioisotope generator; it counts as "
           "external power (default 0).");
  t.list(optional, "loads", "load", power.loads, "What uses power besides wheel motors.");
  t.list(optional, "resources", "resource", power.resources, "What events use up.");
  check_unique_names(t, "resources", power.resources);
  if (t.L() == nullptr || power.battery) return;
  if (!power.panels.empty()) t.fault("panels without a battery: there is nothing to feed");
  if (power.generator_w > 0) t.fault("generator_w without a battery: there is nothing to feed");
  if (!power.loads.empty()) t.fault("loads without a battery: there is nothing to feed them");
}

std::vector<Constructor> power_constructors() {
  return {constructor<BatterySpec, read_battery>("battery", "What stores energy."),
          constructor<PanelSpec, read_panel>("panel",
                                             "A flat rectangle that makes power of "
                                             "sunlight; it may turn about two axes."),
          constructor<LoadSpec, read_load>("load", "What uses power."),
          constructor<ResourceSpec, read_resource>("resource", "What events use up."),
          constructor<Shape, read_shape>("shape", "A box or a cylinder.")};
}

}  // namespace lsos
