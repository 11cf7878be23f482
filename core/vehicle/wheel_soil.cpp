#include "vehicle/wheel_soil.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

namespace {

// The way over which resistance to rolling builds up, as the soil ahead of the wheel gives a
// little before it flows. It also keeps a standing wheel from being pushed.
constexpr double rolling_mobilised_m = 0.005;

// Shear displacement in units of K beyond which the anchor is dragged along, at 98 % of the limit.
constexpr double shear_displacements_max = 25;

// Slip sinkage rises in proportion to u at first and to (1 + u_half a) in the end.
constexpr double slip_sinkage_half = 2;

// A wheel that turns slower than this stands: rounding must not roll a parked rover off its anchor.
constexpr double still_mps = 1e-5;

// Below this speed skidding cannot be told from standing.
constexpr double skid_fade_mps = 1e-3;

// std::hypot guards against overflow, which costs more than all the rest of a step.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

// Share of the limit, divided by x: (1 - (1 - e^-x)/x) / x.
double mobilised_by_x(double x) {
  if (x < 1e-4) return 0.5 - x / 6;
  return (1 + std::expm1(-x) / x) / x;
}

}  // namespace

WheelSoil::WheelSoil(const Soil& soil, const Wheel& wheel, double gravity_mps2)
    : soil_(soil),
      wheel_(wheel),
      pressure_(soil, wheel.radius_m, wheel.width_m, gravity_mps2),
      unit_weight_npm3_(soil.density_kgpm3 * gravity_mps2) {
  const double wedge = std::tan(std::numbers::pi / 4 + soil.friction_rad / 2);
  const double h = wheel.grouser_height_m, b = wheel.width_m;
  if (!soil.is_rigid && h > 0) {
    const double filled = wheel.grouser_count * h * wedge;
    cover_ = std::min(1.0, filled / (2 * std::numbers::pi * wheel.radius_m));
  }
  shear_radius_m_ = wheel.radius_m + cover_ * h;
  interface_ = soil.is_rigid ? 1 : wheel.interface_friction_ratio * (1 - cover_) + cover_;
  const double sides = cover_ > 0 ? 0.64 * h / b * std::atan(b / h) : 0;
  shear_per_area_pa_ = soil.cohesion_pa * (1 + (cover_ > 0 ? 2 * h / b : 0));
  shear_per_load_ = std::tan(soil.friction_rad) * (1 + sides);
  wedge_ = wedge;
}

double WheelSoil::soil_shear_n(double load_n, double contact_length_m) const {
  return wheel_.width_m * contact_length_m * shear_per_area_pa_ + load_n * shear_per_load_;
}

double WheelSoil::traction_limit_n(double load_n, double contact_length_m) const {
  return interface_ * soil_shear_n(load_n, contact_length_m);
}

double WheelSoil::ploughing_n(double width_m, double depth_m) const {
  const double wide_m = width_m + 0.5 * wedge_ * depth_m;
  return wide_m * depth_m * wedge_ *
         (0.5 * unit_weight_npm3_ * depth_m * wedge_ + 2 * soil_.cohesion_pa);
}

// On rock the contact is where the wheel is flattened.
double WheelSoil::contact_length_m(double sinkage_m, double load_n) const {
  const double deep_m = soil_.is_rigid ? load_n / wheel_.normal_stiffness_npm
                                       : sinkage_m + (shear_radius_m_ - wheel_.radius_m);
  const double z = std::min(deep_m, shear_radius_m_);
  return std::sqrt(z * (2 * shear_radius_m_ - z));
}

WheelContactForces WheelSoil::forces(const WheelContactInput& input, double step_s,
                                     WheelContactState& state) const {
  WheelContactForces forces;
  forces.arm_m = shear_radius_m_;
  if (input.load_n <= 0) {
    state = {};
    return forces;
  }
  const double load_n = input.load_n;
  const Vec3& n = input.normal_S;
  const Vec3 left_S = n.cross(input.heading_S);
  const double static_m = pressure_.static_sinkage_m(load_n);

  // Slip shears the soil; rolling brings fresh soil under the rim. In steady rolling the balance
  // of both leaves the mean displacement of the contact.
  const double before_m = std::max(state.sinkage_m, static_m);
  const double length_m = contact_length_m(before_m, load_n);
  const double ahead_mps = input.hub_velocity_S_mps.dot(input.heading_S);
  const double left_mps = input.hub_velocity_S_mps.dot(left_S);
  const double rim_mps = input.rolling_speed_mps * shear_radius_m_ / wheel_.radius_m;
  const double curvature = 0.5 * (soil_.is_rigid ? 0 : before_m / shear_radius_m_);
  const double slip_ahead_mps = ahead_mps * (1 - curvature) - rim_mps;
  const double rolled_mps = std::max(0.0, std::abs(input.rolling_speed_mps) - still_mps);
  const double fresh = 1 / (1 + 2 * rolled_mps * step_s / length_m);
  const double before_ahead_m = state.shear_S_m.dot(input.heading_S);
  const double before_left_m = state.shear_S_m.dot(left_S);
  double j_ahead_m = fresh * (before_ahead_m + slip_ahead_mps * step_s);
  double j_left_m = fresh * (before_left_m + left_mps * step_s);
  double by_K = length(j_ahead_m / soil_.shear_modulus_x_m, j_left_m / soil_.shear_modulus_y_m);
  if (by_K > shear_displacements_max) {
    j_ahead_m *= shear_displacements_max / by_K;
    j_left_m *= shear_displacements_max / by_K;
    by_K = shear_displacements_max;
  }
  state.shear_S_m = j_ahead_m * input.heading_S + j_left_m * left_S;

  const double u = 2 * length(j_ahead_m, j_left_m) / length_m;
  const double z = std::min(static_m * (1 + soil_.slip_sinkage * u / (1 + u / slip_sinkage_half)),
                            1.5 * wheel_.radius_m);
  state.sinkage_m = forces.sinkage_m = z;

  forces.soil_shear_n = soil_shear_n(load_n, length_m);
  forces.traction_limit_n = interface_ * forces.soil_shear_n;
  const double limit_n = forces.traction_limit_n;
  const double share_by_K = 2 * limit_n * mobilised_by_x(2 * by_K);
  // Damping acts on the change of shear, so that steady slip has none of it.
  const double c = wheel_.tangential_damping_nspm;
  double traction_ahead_n =
      -share_by_K * j_ahead_m / soil_.shear_modulus_x_m - c * (j_ahead_m - before_ahead_m) / step_s;
  double traction_left_n =
      -share_by_K * j_left_m / soil_.shear_modulus_y_m - c * (j_left_m - before_left_m) / step_s;
  const double traction_n = length(traction_ahead_n, traction_left_n);
  if (traction_n > limit_n) {
    traction_ahead_n *= limit_n / traction_n;
    traction_left_n *= limit_n / traction_n;
  }
  forces.traction_S_n = traction_ahead_n * input.heading_S + traction_left_n * left_S;

  // Resistance to rolling, built up over a short way and turned round with it.
  state.rolled_m =
      std::clamp(state.rolled_m + ahead_mps * step_s, -rolling_mobilised_m, rolling_mobilised_m);
  const double built_up = state.rolled_m / rolling_mobilised_m;
  // Only a wheel that moves on into what it has built up ploughs.
  const double onward = built_up < 0 ? -1 : 1;
  const double skid =
      std::clamp(onward * (ahead_mps - rim_mps) / (std::abs(ahead_mps) + skid_fade_mps), 0.0,
                 std::clamp(onward * ahead_mps / skid_fade_mps, 0.0, 1.0));
  double against_n = wheel_.rolling_resistance * load_n;
  double side_n = 0;
  if (!soil_.is_rigid) {
    against_n += pressure_.compaction_resistance_n(z, load_n);
    if (skid > 0) against_n += skid * ploughing_n(wheel_.width_m, z);
    const double pushed = -std::expm1(-std::abs(j_left_m) / soil_.shear_modulus_y_m);
    side_n = -std::copysign(ploughing_n(2 * pressure_.contact_length_m(z), z) * pushed, j_left_m);
  }
  const double damping_n = c * (1 - std::abs(built_up)) * ahead_mps;
  forces.at_hub_S_n =
      (-against_n * built_up - std::clamp(damping_n, -against_n, against_n)) * input.heading_S +
      side_n * left_S;
  return forces;
}

double normal_load_n(const Wheel& wheel, double penetration_m, double closing_mps) {
  if (penetration_m <= 0) return 0;
  return std::max(
      0.0, wheel.normal_stiffness_npm * penetration_m + wheel.normal_damping_nspm * closing_mps);
}

double slip_ratio(double hub_speed_mps, double rolling_speed_mps) {
  const double hub = std::abs(hub_speed_mps), rolling = std::abs(rolling_speed_mps);
  if (hub < 1e-3 && rolling < 1e-3) return not_modelled;
  const double along = hub_speed_mps * (rolling_speed_mps < 0 ? -1 : 1);  // seen by the rim
  if (rolling >= along) return std::max(-1.0, std::min(1.0, 1 - along / rolling));
  return rolling / along - 1;
}

}  // namespace lsos
