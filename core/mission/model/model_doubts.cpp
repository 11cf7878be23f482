#include "mission/model/model_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "base/units.h"

namespace lsos {

namespace {

// Greatest length of carried equipment, in lengths of the body.
constexpr double longest_share = 10;

void doubt_panel(const PanelSpec& panel, double size_m, std::vector<std::string>& doubts) {
  constexpr double fastest_radps = 0.5;
  if (std::max(panel.length_m, panel.width_m) > longest_share * size_m) {
    doubts.push_back(fmt::format(
        "panels: '{}' is {:g} m x {:g} m, where the chassis is {:g} m long: is it in cm or mm?",
        panel.name, panel.length_m, panel.width_m, size_m));
  }
  if (panel.can_turn() && panel.rate_radps > fastest_radps) {
    doubts.push_back(
        fmt::format("panels: '{}' turns by {:g} rad/s, {:.0f} deg a second: is it in "
                    "deg/s?",
                    panel.name, panel.rate_radps, degrees(panel.rate_radps)));
  }
}

void doubt_battery(const BatterySpec& battery, double mass_kg, double always_w,
                   std::vector<std::string>& doubts) {
  // Specific energy of good cells, 278 Wh/kg; more is impossible even if the whole rover were a
  // battery.
  constexpr double densest_jpkg = 1e6, shortest_s = 600;
  const double kwh = battery.capacity_j / 3.6e6;
  if (battery.capacity_j > densest_jpkg * mass_kg) {
    doubts.push_back(
        fmt::format("battery: capacity_j = {:g}: {:.3g} kWh in a rover of {:.0f} kg is more than "
                    "any battery of its mass holds",
                    battery.capacity_j, kwh, mass_kg));
  }
  const double lasts_s = battery.capacity_j / always_w;
  if (always_w > 0 && lasts_s < shortest_s) {
    doubts.push_back(fmt::format(
        "battery: capacity_j = {:g}: {:.3g} Wh last {:.3g} s for what is always on, {:g} W: is it "
        "in Wh?",
        battery.capacity_j, battery.capacity_j / 3600, lasts_s, always_w));
  }
  constexpr double slowest_s = 30 * 86400.0;
  if (battery.capacity_j > slowest_s * battery.charge_power_max_w) {
    doubts.push_back(fmt::format(
        "battery: charge_power_max_w = {:g}: would fill it in {:.0f} d; is it in kW?",
        battery.charge_power_max_w, battery.capacity_j / battery.charge_power_max_w / 86400));
  }
  if (battery.discharge_power_max_w < always_w) {
    doubts.push_back(fmt::format(
        "battery: discharge_power_max_w = {:g}: does not feed what is always on, {:g} W; is it in "
        "kW?",
        battery.discharge_power_max_w, always_w));
  }
}

void doubt_antenna(const AntennaSpec& antenna, std::vector<std::string>& doubts) {
  constexpr double shortest_m = 100;
  if (antenna.range_max_m < shortest_m) {
    doubts.push_back(fmt::format("antennas: '{}' reaches {:g} m: is it in km?", antenna.name,
                                 antenna.range_max_m));
  }
  if (antenna.stowed_p_B_m && antenna.p_B_m.z() < antenna.stowed_p_B_m->z()) {
    doubts.push_back(
        fmt::format("antennas: '{}' is lower when it is up ({:g} m) than stowed "
                    "({:g} m)",
                    antenna.name, antenna.p_B_m.z(), antenna.stowed_p_B_m->z()));
  }
}

// Flags springs so soft that the vehicle would rest on its stops.
void doubt_springs(const Suspension& suspension, double mass_kg, std::vector<std::string>& doubts) {
  constexpr double longest_period_s = 6;
  const auto* wishbone = std::get_if<Wishbone>(&suspension);
  if (wishbone == nullptr || wishbone->modules.empty()) return;
  const double stiffness_npm =
      wishbone->stiffness_npm * static_cast<double>(wishbone->modules.size());
  const double period_s = 2 * std::numbers::pi * std::sqrt(mass_kg / stiffness_npm);
  if (period_s <= longest_period_s) return;
  doubts.push_back(
      fmt::format("spring: stiffness_npm = {:g}: {:.0f} kg on it would sway with a period of "
                  "{:.0f} s; is it in "
                  "N/mm or kN/m?",
                  wishbone->stiffness_npm, mass_kg, period_s));
}

void doubt_loads(const std::vector<LoadSpec>& loads, double mass_kg,
                 std::vector<std::string>& doubts) {
  constexpr double least_w = 1, small_rover_kg = 50;
  if (mass_kg < small_rover_kg) return;
  for (const LoadSpec& load : loads) {
    if (load.power_w <= 0 || load.power_w >= least_w) continue;
    doubts.push_back(
        fmt::format("loads: '{0}' takes {1:g} W, in a rover of {2:.0f} kg: is it "
                    "{1:g} kW?",
                    load.name, load.power_w, mass_kg));
  }
}

// Flags motors too weak for level ground on any body: less than against the resistance of a
// thirtieth of the rover's weight on the Moon, which wheels on regolith have at least.
void doubt_motors(const VehicleConfig& vehicle, double mass_kg, std::vector<std::string>& doubts) {
  constexpr double lunar_gravity_mps2 = 1.62, least_resistance = 1.0 / 30;
  double power_w = 0;
  for (const LinkConfig& link : vehicle.links) {
    if (link.drive) power_w += link.drive->power_max_w;
  }
  const double needed_w =
      least_resistance * mass_kg * lunar_gravity_mps2 * vehicle.cruise_speed_mps;
  if (power_w >= needed_w) return;
  doubts.push_back(fmt::format(
      "drive: power_max_w: its motors give {:g} W together, where cruise_speed_mps = {:g} takes "
      "some {:.0f} W for {:.0f} kg on the level: is it in kW?",
      power_w, vehicle.cruise_speed_mps, needed_w, mass_kg));
}

}  // namespace

std::vector<std::string> rover_doubts(const RoverModel& rover) {
  std::vector<std::string> doubts;
  const VehicleConfig vehicle = make_vehicle(rover.spec, "", 1);
  const double mass_kg = vehicle.mass_kg(), size_m = vehicle.chassis_size_m.maxCoeff();
  for (const PanelSpec& panel : rover.power.panels) doubt_panel(panel, size_m, doubts);
  const double always_w = load_w(rover.power.loads, {false, true});
  if (rover.power.battery) doubt_battery(*rover.power.battery, mass_kg, always_w, doubts);
  doubt_loads(rover.power.loads, mass_kg, doubts);
  doubt_motors(vehicle, mass_kg, doubts);
  for (const AntennaSpec& antenna : rover.antennas) doubt_antenna(antenna, doubts);
  doubt_springs(rover.spec.suspension, mass_kg, doubts);
  return doubts;
}

std::vector<std::string> asset_doubts(const AssetModel& asset) {
  std::vector<std::string> doubts;
  if (asset.antenna_height_m > highest_mast_m) {
    doubts.push_back(fmt::format("antenna_height_m = {:g}: is it in cm?", asset.antenna_height_m));
  }
  constexpr double longest_panel_m = 200;
  for (const PanelSpec& panel : asset.panels) {
    if (std::max(panel.length_m, panel.width_m) <= longest_panel_m) continue;
    doubts.push_back(fmt::format("panels: '{}' is {:g} m x {:g} m: is it in cm or mm?", panel.name,
                                 panel.length_m, panel.width_m));
  }
  return doubts;
}

std::vector<std::string> soil_doubts(const Soil& soil) {
  std::vector<std::string> doubts;
  const auto doubt = [&](const char* key, double value, double low, double high,
                         const char* question) {
    if (value >= low && value <= high) return;
    doubts.push_back(fmt::format("soil {}: {} = {:g}: soils have {:g} to {:g}; {}", soil.name, key,
                                 value, low, high, question));
  };
  doubt("density_kgpm3", soil.density_kgpm3, 100, 6000, "is it in g/cm3?");
  if (soil.is_rigid) return doubts;
  doubt("shear_modulus_x_m", soil.shear_modulus_x_m, 1e-4, 0.3, "is it in cm?");
  doubt("shear_modulus_y_m", soil.shear_modulus_y_m, 1e-4, 0.3, "is it in cm?");
  if (soil.cohesion_pa > 0) doubt("cohesion_pa", soil.cohesion_pa, 1, 3e5, "is it in kPa?");
  if (soil.friction_rad > 0) {
    doubt("friction_rad", soil.friction_rad, 0.1, 1.2, "are degrees taken for radians?");
  }
  return doubts;
}

}  // namespace lsos
