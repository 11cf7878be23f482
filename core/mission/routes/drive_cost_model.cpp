#include "mission/routes/drive_cost_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "mission/routes/soil_drive.h"
#include "mission/routes/uneven_loads.h"
#include "vehicle/drive_control.h"
#include "vehicle/part_pose.h"
#include "vehicle/single_wheel.h"

namespace lsos {

namespace {

// Limits for rovers whose script gives none: `tip_share` of the slope that tips the rover over at
// rest, `clearance_share` of its clearance, `uneven_radii` of its smallest wheel.
constexpr double tip_share = 0.6, usual_slip_max = 0.6, clearance_share = 0.3, uneven_radii = 1;

// What dampers take on rough ground: C v r / L^2 for each metre, with C that of all of them, r the
// roughness and L the wheelbase, times this length. Fitted to simulated drives of SEV and LRV on
// LunarSouthPole (the test RoughGround says how well).
constexpr double damped_m = 2.2;
// Rough ground tilts a rover by its height over half the track, and the more suddenly the faster
// the rover passes its own wheelbase: the sine of the tilt that makes it slide to either side has
// the standard deviation `rough_tilt_s2` * roughness * (speed / wheelbase)^2 / (track / 2). Fitted
// to the times that SEV and LRV take over LunarSouthPole (PlannedTurns).
constexpr double rough_tilt_s2 = 11, least_base_m = 0.1;

// Static tipping angle: the slope at which the centre of mass stands above a side of the rectangle
// of the wheels.
double tipping_rad(const VehicleConfig& vehicle, const std::vector<Vec2>& wheels_B_m) {
  Vec2 low_m = wheels_B_m.front(), high_m = low_m;
  for (const Vec2& wheel : wheels_B_m) {
    low_m = low_m.cwiseMin(wheel);
    high_m = high_m.cwiseMax(wheel);
  }
  Vec3 sum = vehicle.chassis.mass_kg * vehicle.p_BC_m;
  const std::vector<Vec3> centres_B_m = centres_at_rest_B_m(vehicle);
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    sum += vehicle.links[i].inertia.mass_kg * centres_B_m[i + 1];
  }
  const Vec3 centre_B_m = sum / vehicle.mass_kg();
  const double nearest_m = std::min({centre_B_m.x() - low_m.x(), high_m.x() - centre_B_m.x(),
                                     centre_B_m.y() - low_m.y(), high_m.y() - centre_B_m.y()});
  return std::atan2(nearest_m, centre_B_m.z());
}

// Time that speeding up from rest to speed V loses against driving at V: the integral of (1 - v /
// V) / a(v) dv. The rims accelerate as commanded or as the motors' power allows; the rover lags
// behind them by its slip.
double speeding_up_s(const VehicleConfig& vehicle, const std::vector<WheelDrive>& wheels,
                     double drag_n, double slip, double speed_mps) {
  constexpr int steps = 50;
  double lost_s = 0;
  for (int k = 0; k < steps; ++k) {
    const double now_mps = speed_mps * (k + 0.5) / steps;
    double pull_n = 0;
    for (const WheelDrive& wheel : wheels) {
      if (!wheel.motor) continue;
      pull_n += std::min(wheel.motor->torque_max_n_m / wheel.wheel.radius_m,
                         wheel.motor->power_max_w / now_mps);
    }
    const double left_mps2 = (pull_n - drag_n) / vehicle.mass_kg();
    const double gained_mps2 =
        std::clamp(left_mps2, 0.1 * vehicle.acceleration_mps2, vehicle.acceleration_mps2);
    lost_s += speed_mps / steps / gained_mps2 * (1 - now_mps / speed_mps);
  }
  return lost_s + slip * speed_mps / vehicle.acceleration_mps2 / 2;
}

// Time to steer the wheels for a turn on the spot, and back. Driving begins before they point
// there, which saves about the time for `driven_rad`, see wheel_targets().
double steer_s(const VehicleConfig& vehicle) {
  constexpr double driven_rad = 0.5;
  const WheelLayout layout = wheel_layout(vehicle);
  double longest_s = 0;
  for (const WheelLayout::Steering& steering : layout.steerings) {
    const Vec2 at_m(steering.p_B_m.x() - layout.turning_x_B_m, steering.p_B_m.y());
    const double angle_rad = std::atan2(std::abs(at_m.x()), std::abs(at_m.y()));
    const auto& motor = vehicle.links[static_cast<std::size_t>(steering.link)].steering;
    longest_s = std::max(longest_s, (angle_rad - driven_rad) / motor->rate_max_radps);
  }
  return 2 * longest_s;
}

// Adds what corners, arcs and rough ground cost beyond steady straight driving: the speed lost by
// stopping, and wheels that roll round the centre in a turn on the spot. Wheels that cannot steer
// are dragged there, which is not counted.
void add_corners(const VehicleConfig& vehicle, const std::vector<WheelDrive>& wheels,
                 double gravity_mps2, DriveCost& cost) {
  double efficiency = 1, driven = 0, winding_w_pn2 = 0;
  for (const WheelDrive& wheel : wheels) {
    if (!wheel.motor) continue;
    ++driven;
    efficiency = std::min(efficiency, wheel.motor->efficiency);
    const double radius_m = wheel.wheel.radius_m;
    winding_w_pn2 += wheel.motor->winding_loss_w_pn2m2 * radius_m * radius_m;
    cost.idle_w += vehicle.drive_calibration * wheel.motor->idle_w;
  }
  if (vehicle.posture) {
    for (const LinkConfig& link : vehicle.links) {
      if (link.limb) cost.idle_w += link.limb->motor.idle_w;
    }
  }
  // Loss in all windings by the square of the whole pull, which the driven wheels share evenly.
  if (driven > 0) winding_w_pn2 *= vehicle.drive_calibration / (driven * driven);
  double reach_m = 0;
  for (const Vec2& wheel : cost.wheels_B_m) reach_m += wheel.norm();
  reach_m /= static_cast<double>(cost.wheels_B_m.size());
  // Electrical energy per mechanical energy through the gears.
  double electrical_per_mechanical = vehicle.drive_calibration / efficiency;
  const double mass_kg = vehicle.mass_kg(), speed2 = cost.speed_mps * cost.speed_mps;
  const double braking_n = mass_kg * vehicle.acceleration_mps2;
  // Drag of the soil: the speed that it takes is not lost in the brakes.
  double drag_n = 0;
  if (!cost.soils.front().by_slope.empty()) {
    const SlopeDrive level = cost.soils.front().at(0);
    drag_n = (level.energy_jpm - level.lost_jpm) / electrical_per_mechanical;
  }
  // Windings that bear the drag lose so much more for each newton more.
  electrical_per_mechanical += 2 * winding_w_pn2 * drag_n / cost.speed_mps;
  // Beyond that, speeding up loses by the square of the pull that it takes, for V / a seconds.
  const double speeding_j = winding_w_pn2 * braking_n * mass_kg * cost.speed_mps;
  constexpr double slowing_share = 0.69;  // mean of (1 - s) / (1 - s^2) over speeds s V
  cost.speeding_kg = electrical_per_mechanical * mass_kg;
  cost.slow_j = electrical_per_mechanical * mass_kg * speed2 / 2 *
                    std::max(0.0, braking_n - drag_n) / braking_n +
                slowing_share * speeding_j;
  cost.stop_j =
      electrical_per_mechanical * mass_kg * speed2 / 2 * braking_n / (braking_n + drag_n) +
      speeding_j;
  cost.acceleration_mps2 = vehicle.acceleration_mps2;
  if (!cost.soils.front().by_slope.empty()) {
    const SlopeDrive level = cost.soils.front().at(0);
    cost.side_slip_s2pm = level.side_slip_s2pm;
    cost.side_grip_mps2 = level.side_grip_mps2;
  }
  cost.gravity_mps2 = gravity_mps2;
  Vec2 low_m = cost.wheels_B_m.front(), high_m = low_m;
  for (const Vec2& wheel : cost.wheels_B_m) {
    low_m = low_m.cwiseMin(wheel);
    high_m = high_m.cwiseMax(wheel);
  }
  const Vec2 base_m = (high_m - low_m).cwiseMax(least_base_m);
  const double passing_1ps = cost.speed_mps / base_m.x();
  cost.rough_tilt_1pm = rough_tilt_s2 * passing_1ps * passing_1ps / (base_m.y() / 2);
  cost.arc_drag_jmprad =
      electrical_per_mechanical * mass_kg * speed2 * speed2 * cost.side_slip_s2pm;
  double damping_nspm = 0;
  for (const LinkConfig& link : vehicle.links) {
    if (link.joint == JointType::prismatic && link.spring) damping_nspm += link.spring->damping;
  }
  cost.rough_jspm3 =
      electrical_per_mechanical * damped_m * damping_nspm / (base_m.x() * base_m.x());
  const double braking_s = cost.speed_mps / vehicle.acceleration_mps2 / 2;
  cost.stop_s = 2 * braking_s;
  if (!cost.soils.front().by_slope.empty()) {
    const double as_steep_rad = std::atan(vehicle.acceleration_mps2 / gravity_mps2);
    const double slip =
        std::max(0.0, cost.soils.front().at(as_steep_rad).slip - cost.soils.front().at(0).slip);
    cost.stop_s = speeding_up_s(vehicle, wheels, drag_n, slip, cost.speed_mps) + braking_s;
    cost.turn_jprad = cost.soils.front().at(0).energy_jpm * reach_m;
  }
  cost.turn_sprad = 1 / turn_rate_radps(vehicle);
  cost.steer_s = steer_s(vehicle);
}

}  // namespace

DriveCost drive_cost(const VehicleConfig& vehicle, const std::vector<Soil>& soils,
                     double gravity_mps2, double speed_mps, const GroundLimits& limits) {
  DriveCost cost;
  cost.limits.slip_max = limits.slip_max.value_or(usual_slip_max);
  const std::vector<Vec3> centres_B_m = centres_at_rest_B_m(vehicle);
  double radius_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    if (!vehicle.links[i].wheel) continue;
    cost.wheels_B_m.push_back(centres_B_m[i + 1].head<2>());
    radius_m = std::min(radius_m, vehicle.links[i].wheel->radius_m);
  }
  cost.gravity_mps2 = gravity_mps2;
  cost.uneven_1pm = uneven_load_1pm(vehicle, cost);
  const std::vector<WheelDrive> wheels = wheels_of(vehicle);
  const double slip_max = cost.limits.slip_max;
  for (const Soil& soil : soils) {
    SoilDrive drive = soil_drive(vehicle, wheels, soil, gravity_mps2, speed_mps, slip_max);
    add_uneven_loads(drive, vehicle, wheels, soil, gravity_mps2, speed_mps, slip_max);
    if (soil.is_rigid && !cost.soils.empty()) raise_to_soil_cost(drive, cost.soils.front());
    cost.soils.push_back(std::move(drive));
  }
  const Vec2 half_m = vehicle.chassis_size_m.head<2>() / 2;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      cost.underside_B_m.push_back({x * half_m.x(), y * half_m.y(), vehicle.chassis_clearance_m});
    }
  }
  cost.limits.slope_max_rad =
      limits.slope_max_rad.value_or(tip_share * tipping_rad(vehicle, cost.wheels_B_m));
  cost.limits.clearance_min_m =
      limits.clearance_min_m.value_or(clearance_share * vehicle.chassis_clearance_m);
  cost.limits.unevenness_max_m = limits.unevenness_max_m.value_or(uneven_radii * radius_m);
  cost.turning_radius_min_m = vehicle.turning_radius_min_m;
  cost.can_turn_on_spot = vehicle.can_turn_on_spot;
  cost.speed_mps = speed_mps;
  cost.level_speed_mps = std::max(speed_mps, vehicle.cruise_speed_mps);
  add_corners(vehicle, wheels, gravity_mps2, cost);
  return cost;
}

double wheel_reach_m(const VehicleConfig& vehicle) {
  double reach_m = 0.3;
  for (const WheelLayout::WheelPlace& wheel : wheel_layout(vehicle).wheels) {
    reach_m = std::max(reach_m, wheel.p_B_m.norm());
  }
  return reach_m;
}

double turn_rate_radps(const VehicleConfig& vehicle) {
  // In a turn on the spot the farthest wheel runs at this share of the cruise speed, of which at
  // most `speed_max_mps` counts.
  constexpr double wheels_share = 0.4, speed_max_mps = 1;
  return wheels_share * std::min(vehicle.cruise_speed_mps, speed_max_mps) / wheel_reach_m(vehicle);
}

}  // namespace lsos
