#include "mission/routes/soil_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace lsos {

namespace {

// Slopes of the table: -40 to 40 degrees in steps of 1.25 degrees.
const double first_rad = radians(-40), step_rad = radians(1.25);
constexpr int rows_max = 65;
// The slip of a driven wheel is searched in this many steps from `slip_least` to the limit; the
// least that pulls enough is taken.
constexpr int slip_steps = 24;
constexpr double slip_least = -0.5;
constexpr int halvings = 5;

// Linear interpolation between two states of a wheel.
SingleWheelPoint point_between(const SingleWheelPoint& low, const SingleWheelPoint& high,
                               double share) {
  SingleWheelPoint point;
  point.slip = low.slip + share * (high.slip - low.slip);
  point.torque_n_m = low.torque_n_m + share * (high.torque_n_m - low.torque_n_m);
  return point;
}

// Resistance of a wheel without a motor, which rolls freely or is locked (slip -1).
double drag_n(const WheelDrive& wheel, const Soil& soil, double load_n, double gravity_mps2) {
  const double slip = wheel.is_locked ? -1 : 0;
  const WheelSoil on_soil(soil, wheel.wheel, gravity_mps2);
  return std::max(0.0, -single_wheel(on_soil, load_n, slip, 0).drawbar_pull_n);
}

// State of that pull between two states that pull less and enough. A wheel without slip sinks
// least, so that pull and torque have a kink there; the interval is halved before it is
// interpolated.
SingleWheelPoint between_at_pull(const WheelSoil& wheel, double load_n, double pull_n,
                                 SingleWheelPoint low, SingleWheelPoint high) {
  for (int k = 0; k < halvings; ++k) {
    const SingleWheelPoint middle = single_wheel(wheel, load_n, (low.slip + high.slip) / 2, 0);
    (middle.drawbar_pull_n >= pull_n ? high : low) = middle;
  }
  const double rise_n = high.drawbar_pull_n - low.drawbar_pull_n;
  return point_between(low, high, (pull_n - low.drawbar_pull_n) / rise_n);
}

// Travel speed at which the motor still gives the torque of `point`, m/s; absent when it cannot.
std::optional<double> motor_speed_max_mps(const DriveMotor& motor, const SingleWheelPoint& point,
                                          double radius_m) {
  if (point.torque_n_m <= 0) return std::numeric_limits<double>::infinity();
  if (point.torque_n_m >= motor.torque_max_n_m) return std::nullopt;
  double spin_radps = motor.power_max_w / point.torque_n_m;
  if (std::isfinite(motor.no_load_speed_radps)) {
    spin_radps = std::min(
        spin_radps, motor.no_load_speed_radps * (1 - point.torque_n_m / motor.torque_max_n_m));
  }
  return spin_radps * radius_m * (1 - std::max(0.0, point.slip));
}

// Side force of one wheel at a slip angle and at twice that.
struct SideForces {
  double once_n = 0, twice_n = 0;
};

constexpr double tested_rad = 0.05;

SideForces side_forces(const WheelSoil& wheel, double load_n, double slip) {
  return {std::abs(single_wheel(wheel, load_n, slip, tested_rad).side_force_n),
          std::abs(single_wheel(wheel, load_n, slip, 2 * tested_rad).side_force_n)};
}

// Fits the curve of driving/side_slip.h to the forces of all wheels: with e = F2 / F1 - 1,
//  F_max = F1 / (1 - e),  C = -ln(e) F_max / angle.
void set_side_slip(SlopeDrive& drive, const SideForces& sum, double mass_kg) {
  constexpr double least_n = 0.05, least_e = 0.01;
  const double once_n = std::max(least_n, sum.once_n);
  const double e = std::clamp(sum.twice_n / once_n - 1, least_e, 1 - least_e);
  drive.side_grip_mps2 = once_n / (1 - e) / mass_kg;
  drive.side_slip_s2pm = tested_rad / (-std::log(e) * drive.side_grip_mps2);
}

std::optional<SlopeDrive> slope_drive(const VehicleConfig& vehicle,
                                      const std::vector<WheelDrive>& wheels, const Soil& soil,
                                      double gravity_mps2, double speed_mps, double slip_max,
                                      double slope_rad) {
  const double weight_n = vehicle.mass_kg() * gravity_mps2;
  const auto count = static_cast<double>(wheels.size());
  const auto driven = static_cast<double>(
      std::ranges::count_if(wheels, [](const WheelDrive& w) { return w.motor.has_value(); }));
  if (driven == 0) return std::nullopt;
  const double load_n = weight_n * std::cos(slope_rad) / count;
  double held_n = weight_n * std::sin(slope_rad);
  SideForces sides_n;
  for (const WheelDrive& wheel : wheels) {
    if (wheel.motor) continue;
    held_n += drag_n(wheel, soil, load_n, gravity_mps2);
    const SideForces side =
        side_forces(WheelSoil(soil, wheel.wheel, gravity_mps2), load_n, wheel.is_locked ? -1 : 0);
    sides_n.once_n += side.once_n;
    sides_n.twice_n += side.twice_n;
  }
  const double pull_n = held_n / driven;
  SlopeDrive drive;
  drive.speed_mps = std::numeric_limits<double>::infinity();
  // Successive wheels that are alike are computed once.
  std::optional<SingleWheelPoint> point;
  SideForces side_n;
  const WheelDrive* of = nullptr;
  double winding_w = 0, generated_jpm = 0;
  for (const WheelDrive& wheel : wheels) {
    if (!wheel.motor) continue;
    const WheelSoil on_soil(soil, wheel.wheel, gravity_mps2);
    const double radius_m = on_soil.rolling_radius_m(load_n);
    if (of == nullptr || of->wheel != wheel.wheel) {
      point = state_at_pull(on_soil, load_n, pull_n, slip_max);
      if (point) side_n = side_forces(on_soil, load_n, point->slip);
    }
    of = &wheel;
    if (!point) return std::nullopt;
    sides_n.once_n += side_n.once_n;
    sides_n.twice_n += side_n.twice_n;
    const std::optional<double> left_mps = motor_speed_max_mps(*wheel.motor, *point, radius_m);
    if (!left_mps) return std::nullopt;
    const double slip = std::max(0.0, point->slip);
    drive.slip = std::max(drive.slip, slip);
    // Metres rolled per metre of ground: 1 / (1 - slip) driving, 1 + slip braking. The rims, whose
    // radius is less than the rolling radius, turn at the requested speed.
    const double rolled_per_travel = point->slip > 0 ? 1 / (1 - point->slip) : 1 + point->slip;
    const double rolled_mps = speed_mps * radius_m / wheel.wheel.radius_m;
    drive.speed_mps = std::min({drive.speed_mps, *left_mps, rolled_mps / rolled_per_travel});
    const double work_jpm = point->torque_n_m / radius_m * rolled_per_travel;
    if (work_jpm > 0) {
      drive.energy_jpm += work_jpm / wheel.motor->efficiency;
    } else {
      drive.spare_jpm -= work_jpm / wheel.motor->efficiency;
      generated_jpm -= work_jpm * wheel.motor->efficiency;
    }
    drive.lost_jpm += wheel.motor->friction_n_m / radius_m * rolled_per_travel;
    winding_w += wheel.motor->winding_loss_w_pn2m2 * point->torque_n_m * point->torque_n_m;
  }
  if (drive.speed_mps <= 0) return std::nullopt;
  drive.lost_jpm += winding_w / drive.speed_mps;
  // What the motors of a braking rover generate covers their losses, see drive_power.h.
  if (generated_jpm > 0) {
    const double covered_jpm = std::min(generated_jpm, drive.lost_jpm);
    drive.spare_jpm *= 1 - covered_jpm / generated_jpm;
    drive.lost_jpm -= covered_jpm;
  }
  drive.energy_jpm += drive.lost_jpm;
  drive.energy_jpm *= vehicle.drive_calibration;
  drive.lost_jpm *= vehicle.drive_calibration;
  drive.spare_jpm *= vehicle.drive_calibration;
  set_side_slip(drive, sides_n, vehicle.mass_kg());
  return drive;
}

}  // namespace

std::vector<WheelDrive> wheels_of(const VehicleConfig& vehicle) {
  std::vector<WheelDrive> wheels;
  for (const LinkConfig& link : vehicle.links) {
    if (!link.wheel) continue;
    const bool is_driven = link.drive && link.wheel_mode == WheelMode::driven;
    wheels.push_back(
        {*link.wheel, is_driven ? link.drive : std::nullopt, link.wheel_mode == WheelMode::locked});
  }
  return wheels;
}

std::optional<SingleWheelPoint> state_at_pull(const WheelSoil& wheel, double load_n, double pull_n,
                                              double slip_max) {
  SingleWheelPoint before = single_wheel(wheel, load_n, slip_least, 0);
  if (before.drawbar_pull_n >= pull_n) return before;
  for (int k = 1; k <= slip_steps; ++k) {
    const double slip = slip_least + (slip_max - slip_least) * k / slip_steps;
    const SingleWheelPoint now = single_wheel(wheel, load_n, slip, 0);
    if (now.drawbar_pull_n >= pull_n) return between_at_pull(wheel, load_n, pull_n, before, now);
    before = now;
  }
  return std::nullopt;
}

SoilDrive soil_drive(const VehicleConfig& vehicle, const std::vector<WheelDrive>& wheels,
                     const Soil& soil, double gravity_mps2, double speed_mps, double slip_max) {
  SoilDrive drive{first_rad, step_rad, {}, {}};
  for (int k = 0; k < rows_max; ++k) {
    const auto row = slope_drive(vehicle, wheels, soil, gravity_mps2, speed_mps, slip_max,
                                 first_rad + k * step_rad);
    if (!row) break;
    drive.by_slope.push_back(*row);
  }
  return drive;
}

void raise_to(SlopeDrive& drive, const SlopeDrive& least) {
  drive.energy_jpm = std::max(drive.energy_jpm, least.energy_jpm);
  drive.lost_jpm = std::max(drive.lost_jpm, least.lost_jpm);
  drive.spare_jpm = std::min(drive.spare_jpm, least.spare_jpm);
  drive.speed_mps = std::min(drive.speed_mps, least.speed_mps);
  drive.slip = std::max(drive.slip, least.slip);
  drive.side_slip_s2pm = std::max(drive.side_slip_s2pm, least.side_slip_s2pm);
  drive.side_grip_mps2 = std::min(drive.side_grip_mps2, least.side_grip_mps2);
}

void raise_to_soil_cost(SoilDrive& rock, const SoilDrive& soil) {
  const std::size_t rows = std::min(rock.by_slope.size(), soil.by_slope.size());
  rock.by_slope.resize(rows);
  for (std::size_t k = 0; k < rows; ++k) raise_to(rock.by_slope[k], soil.by_slope[k]);
  rock.uneven.resize(std::min({rows, rock.uneven.size(), soil.uneven.size()}));
  for (std::size_t k = 0; k < rock.uneven.size(); ++k) raise_to(rock.uneven[k], soil.uneven[k]);
}

}  // namespace lsos
