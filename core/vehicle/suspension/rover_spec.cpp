#include "vehicle/suspension/rover_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "vehicle/drive_control.h"
#include "vehicle/limb_stance.h"
#include "vehicle/suspension/link_parts.h"
#include "vehicle/suspension/vehicle_checks.h"

namespace lsos {

namespace {

// Wheels of a stance may stand this far over or in the ground; posture control makes up for it.
constexpr double stance_tolerance_m = 0.01;

template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

const LinkConfig* find_link(const VehicleConfig& vehicle, const std::string& name) {
  const auto found = std::ranges::find(vehicle.links, name, &LinkConfig::name);
  return found == vehicle.links.end() ? nullptr : &*found;
}

const RoverConfiguration* find_configuration(const RoverSpec& spec, const std::string& name) {
  const auto found = std::ranges::find(spec.configurations, name, &RoverConfiguration::name);
  return found == spec.configurations.end() ? nullptr : &*found;
}

// Applies the height of a stance, and returns why a limb cannot; see stand().
std::string apply_height(VehicleConfig& vehicle, const RoverConfiguration& configuration) {
  if (vehicle.limbs.empty() || !configuration.height_m) return "";
  return stand(vehicle, at_height(vehicle, hubs_B_m(vehicle), *configuration.height_m));
}

// Applies joint positions and wheel modes. Unknown names are ignored here; configuration_faults
// reports them.
void apply(VehicleConfig& vehicle, const RoverConfiguration& configuration) {
  for (LinkConfig& link : vehicle.links) {
    const auto joint = configuration.joints.find(link.name);
    if (joint != configuration.joints.end()) link.initial = joint->second;
    if (!link.wheel) continue;
    const auto is_in = [&](const std::vector<std::string>& names) {
      return std::ranges::find(names, link.name) != names.end();
    };
    if (is_in(configuration.free_wheels)) link.wheel_mode = WheelMode::free;
    if (is_in(configuration.locked_wheels)) link.wheel_mode = WheelMode::locked;
  }
  apply_height(vehicle, configuration);
  vehicle.starts_level = configuration.is_level;
}

// What SetPosture may name: the configurations of a vehicle on limbs that are stances.
void add_stances(VehicleConfig& vehicle, const std::vector<RoverConfiguration>& configurations) {
  if (vehicle.limbs.empty()) return;
  for (const RoverConfiguration& configuration : configurations) {
    if (!is_stance(configuration)) continue;
    VehicleConfig standing = vehicle;
    apply(standing, configuration);
    vehicle.stances.push_back({configuration.name, hubs_B_m(standing), configuration.is_level});
  }
}

VehicleConfig make_with(const RoverSpec& spec, const RoverConfiguration* configuration,
                        double gravity_mps2) {
  VehicleConfig vehicle = spec.vehicle;
  // The payload is added before the template, which sets the springs for it.
  if (configuration != nullptr && configuration->payload_mass_kg != 0) {
    add_point_mass(vehicle.chassis, vehicle.p_BC_m, configuration->payload_mass_kg,
                   configuration->p_BP_m);
  }
  std::visit(Overload{[&](const Wishbone& s) { add_wishbone(vehicle, s, gravity_mps2); },
                      [&](const RockerBogie& s) { add_rocker_bogie(vehicle, s); },
                      [&](const SkidSteer& s) { add_skid_steer(vehicle, s); },
                      [&](const Legged& s) { add_legged(vehicle, s); }},
             spec.suspension);
  add_stances(vehicle, spec.configurations);
  if (configuration != nullptr) apply(vehicle, *configuration);
  vehicle.assumptions.push_back(
      fmt::format("{}: drive energy is multiplied by {} (drive_calibration): {}", spec.name,
                  vehicle.drive_calibration,
                  vehicle.drive_calibration_source.empty() ? "not calibrated against field data"
                                                           : vehicle.drive_calibration_source));
  return vehicle;
}

// A bogie supports its rocker only at its pivot, whatever wheels are beyond it.
std::vector<std::string> tipping_faults(const RoverSpec& spec, const VehicleConfig& whole) {
  std::vector<std::string> faults = balance_faults(whole);
  const auto* suspension = std::get_if<RockerBogie>(&spec.suspension);
  if (!faults.empty() || suspension == nullptr || !suspension->bogie) return faults;
  double rear_m = suspension->bogie->p_B_pivot_m.x(), front_m = rear_m;
  for (const WheelStation& station : suspension->stations) {
    if (station.arm == Arm::bogie) continue;
    rear_m = std::min(rear_m, station.p_B_m.x());
    front_m = std::max(front_m, station.p_B_m.x());
  }
  const double center_m = center_of_mass_at_rest_B_m(whole).x();
  if (center_m > rear_m && center_m < front_m) return faults;
  return {
      fmt::format("the centre of mass of the whole, {:.3f} m forward, is not between the "
                  "rockers' wheels and the bogies' pivots, {:.3f} to {:.3f} m: it would tip "
                  "over at rest",
                  center_m, rear_m, front_m)};
}

// Range of a joint's initial position; absent where it is unlimited.
std::optional<std::pair<double, double>> limits(const LinkConfig& link) {
  if (link.spring) return std::pair(link.spring->lower_stop, link.spring->upper_stop);
  if (link.steering) return std::pair(-link.steering->angle_max_rad, link.steering->angle_max_rad);
  if (link.limb) return std::pair(link.limb->angle_min_rad, link.limb->angle_max_rad);
  return {};
}

// Faults of the vehicle, with its load, in the stance of a configuration; none for a vehicle
// without limbs.
std::vector<std::string> stance_faults(const RoverSpec& spec,
                                       const RoverConfiguration& configuration) {
  RoverConfiguration load = configuration;
  load.height_m.reset();
  VehicleConfig standing = make_with(spec, &load, 1);
  if (standing.limbs.empty()) {
    if (!configuration.height_m) return {};
    return {
        fmt::format("height_m = {}: only a rover on limbs (lsos.legged) can stand higher or lower",
                    *configuration.height_m)};
  }
  const std::string hindrance = apply_height(standing, configuration);
  if (!hindrance.empty()) {
    return {fmt::format("height_m = {}: {}", *configuration.height_m, hindrance)};
  }
  standing = as_it_stands(standing);
  std::vector<std::string> faults = rest_faults(standing, stance_tolerance_m);
  std::ranges::move(buried_joint_faults(standing), std::back_inserter(faults));
  if (faults.empty()) faults = balance_faults(standing);
  if (faults.empty()) faults = ability_faults(standing);
  if (faults.empty()) faults = stability_faults(standing);
  return faults;
}

// Faults of a vehicle on limbs as low and as high as it can stand.
std::vector<std::string> height_faults(const VehicleConfig& vehicle) {
  if (vehicle.limbs.empty()) return {};
  const HeightRange range = height_range(vehicle);
  for (const double height_m : {range.least_m, range.greatest_m}) {
    VehicleConfig standing = vehicle;
    stand(standing, at_height(vehicle, hubs_B_m(vehicle), height_m));
    for (const std::string& fault : stability_faults(as_it_stands(standing))) {
      return {fmt::format("{:.2f} m over the ground: {}", height_m, fault)};
    }
  }
  return {};
}

std::vector<std::string> configuration_faults(const RoverSpec& spec,
                                              const RoverConfiguration& configuration) {
  std::vector<std::string> faults;
  const auto fault = [&](const std::string& text) {
    faults.push_back(fmt::format("configuration '{}': {}", configuration.name, text));
  };
  const VehicleConfig plain = make_with(spec, nullptr, 1);
  std::vector<std::string> joints, wheels;
  for (const LinkConfig& link : plain.links) (link.wheel ? wheels : joints).push_back(link.name);

  for (const auto& [name, position] : configuration.joints) {
    const LinkConfig* link = find_link(plain, name);
    if (link == nullptr || link->wheel) {
      std::string hint = did_you_mean(name, joints);
      if (hint.empty()) hint = fmt::format("; it has {}", fmt::join(joints, ", "));
      fault(fmt::format("no joint '{}'{}", name, hint));
      continue;
    }
    const auto range = limits(*link);
    if (range && (position < range->first || position > range->second)) {
      fault(fmt::format("{} = {}: must be {:.4g}..{:.4g} {}", name, position, range->first,
                        range->second, link->joint == JointType::revolute ? "rad" : "m"));
    }
  }
  std::set<std::string> named;
  for (const auto* names : {&configuration.free_wheels, &configuration.locked_wheels}) {
    for (const std::string& name : *names) {
      if (std::ranges::find(wheels, name) == wheels.end()) {
        std::string hint = did_you_mean(name, wheels);
        if (hint.empty()) hint = fmt::format("; it has {}", fmt::join(wheels, ", "));
        fault(fmt::format("no wheel '{}'{}", name, hint));
      } else if (!named.insert(name).second) {
        fault(fmt::format("wheel '{}' is named twice in free_wheels and locked_wheels", name));
      }
    }
  }
  if (configuration.payload_mass_kg != 0 &&
      spec.vehicle.chassis.mass_kg + configuration.payload_mass_kg <= 0) {
    fault(fmt::format("payload_mass_kg = {}: the chassis has only {} kg to take off",
                      configuration.payload_mass_kg, spec.vehicle.chassis.mass_kg));
    return faults;
  }
  if (faults.empty()) {
    for (const std::string& text : stance_faults(spec, configuration)) fault(text);
  }
  if (configuration.payload_mass_kg == 0) return faults;
  const VehicleConfig loaded = make_with(spec, &configuration, 1);
  if (loaded.chassis.moments_kgm2.minCoeff() <= 0) {
    fault("payload_mass_kg: the chassis has no such mass at payload_position_m to take off");
  }
  if (!loaded.limbs.empty()) return faults;  // these were checked in the configuration's stance
  for (const std::string& text : tipping_faults(spec, loaded)) fault(text);
  if (faults.empty()) {
    for (const std::string& text : stability_faults(loaded)) fault(text);
  }
  return faults;
}

std::vector<std::string> suspension_faults(const RoverSpec& spec) {
  return std::visit(Overload{[](const Wishbone& s) { return wishbone_faults(s); },
                             [](const RockerBogie& s) { return rocker_bogie_faults(s); },
                             [](const SkidSteer& s) { return skid_steer_faults(s); },
                             [](const Legged& s) { return legged_faults(s); }},
                    spec.suspension);
}

}  // namespace

bool is_stance(const RoverConfiguration& configuration) {
  return configuration.payload_mass_kg == 0 && configuration.free_wheels.empty() &&
         configuration.locked_wheels.empty();
}

VehicleConfig make_vehicle(const RoverSpec& spec, const std::string& configuration,
                           double gravity_mps2) {
  return make_with(spec, find_configuration(spec, configuration), gravity_mps2);
}

std::vector<std::string> vehicle_faults(const RoverSpec& spec) {
  std::vector<std::string> faults = suspension_faults(spec);
  const auto add = [&](std::vector<std::string> more) {
    std::ranges::move(more, std::back_inserter(faults));
  };
  std::visit([&](const auto& s) { add(grouser_faults(s.wheel)); }, spec.suspension);
  if (spec.vehicle.drive_calibration != 1 && spec.vehicle.drive_calibration_source.empty()) {
    faults.push_back(fmt::format("drive_calibration = {}: needs a drive_calibration_source",
                                 spec.vehicle.drive_calibration));
  }
  if (!faults.empty()) return faults;  // the checks below need a vehicle that can be built

  const VehicleConfig whole = make_with(spec, nullptr, 1);
  if (!std::holds_alternative<SkidSteer>(spec.suspension) &&
      wheel_layout(whole).steerings.empty()) {
    faults.push_back("no wheel is steered: lsos.skid_steer is for rovers that turn without");
  }
  add(rest_faults(whole));
  add(buried_joint_faults(whole));
  add(tipping_faults(spec, whole));
  add(ability_faults(whole));
  if (faults.empty()) add(stability_faults(whole));
  if (faults.empty()) add(height_faults(whole));
  std::set<std::string> names;
  for (const RoverConfiguration& configuration : spec.configurations) {
    if (!names.insert(configuration.name).second) {
      faults.push_back(fmt::format("two configurations are named '{}'", configuration.name));
    }
    add(configuration_faults(spec, configuration));
  }
  return faults;
}

}  // namespace lsos
