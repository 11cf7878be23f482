#include "vehicle/wheel_soil.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

namespace {

// Shear displacement beyond which the anchor is dragged along, the larger of two limits: in units
// of K, at 98 % of the shear strength; in contact lengths, where the wheel skids over nine tenths
// of its travel.
constexpr double shear_displacements_max = 25, shear_lengths_max = 5;

constexpr double sinkage_max_radii = 1.5;

// Slip sinkage factor: 1 + a u for small u, tending to 1 + slip_sinkage_half a.
constexpr double slip_sinkage_half = 2;

// A wheel that turns slower than this stands: rounding must not roll a parked rover off its anchor.
constexpr double still_mps = 1e-5;

// Plain norm: std::hypot guards against overflow, which costs more than the rest of a step.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

// Mobilised share of the shear strength divided by x: (1 - (1 - e^-x)/x) / x.
double mobilised_over_x(double x) {
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
  const double sides = h > 0 ? 0.64 * h / b * std::atan(b / h) : 0;
  shear_per_area_pa_ = soil.cohesion_pa * (1 + cover_ * 2 * h / b);
  shear_per_load_ = std::tan(soil.friction_rad) * (1 + cover_ * sides);
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

// Length from the deepest point to the rim's entry, sqrt(z (2 R - z)), with z the sinkage or, on
// ground that the wheel hardly marks, the flattening of the wheel.
double WheelSoil::contact_length_m(double sinkage_m, double load_n) const {
  const double k = wheel_.normal_stiffness_npm;
  const double flattened_m = k > 0 ? load_n / k : 0;
  const double sunk_m = soil_.is_rigid ? 0 : sinkage_m + (shear_radius_m_ - wheel_.radius_m);
  const double z = std::min(std::max(sunk_m, flattened_m), shear_radius_m_);
  return std::sqrt(z * (2 * shear_radius_m_ - z));
}

// Quantities of one step of one wheel in the plane of the ground: x along its heading, y to its
// left.
struct WheelSoil::Step {
  double load_n = 0, static_sinkage_m = 0, length_m = 0;
  double ahead_mps = 0, left_mps = 0;  // velocity of the hub
  double rim_mps = 0;    // rim speed where soil is sheared, relative to the hub, backwards
  double curvature = 0;  // share by which the rim lags behind the hub, mean over the contact
  Vec2 shear_m = Vec2::Zero(), shear_rate_mps = Vec2::Zero();
  double limit_n = 0;  // H_max
  Vec2 K_m = Vec2::Zero();
  double shear_over_K = 0;
  double rolling_mobilised = 0;  // mobilised share of the rolling resistance, -1..1
  Vec2 slip = Vec2::Zero();      // excess travel for each metre rolled; 0 in rolling without slip
  double sinkage_m = 0;
};

Vec2 WheelSoil::shear_modulus_m(double limit_n) const {
  const double wheel_m = limit_n / wheel_.tangential_stiffness_npm;
  return {std::max(soil_.shear_modulus_x_m, wheel_m), std::max(soil_.shear_modulus_y_m, wheel_m)};
}

// Slip shears the soil and rolling brings fresh soil under the rim:
//  dj/dt = slip speed - 2 |r w| j / l,
// integrated implicitly. In steady rolling the balance of both gives the mean displacement j.
void WheelSoil::shear(Step& step, const Vec2& before_m, double rolling_mps, double step_s) const {
  const double rolled_mps = std::max(0.0, std::abs(rolling_mps) - still_mps);
  const double fresh = 1 / (1 + 2 * rolled_mps * step_s / step.length_m);
  const Vec2 slip_mps(step.ahead_mps * (1 - step.curvature) - step.rim_mps, step.left_mps);
  step.shear_m = fresh * (before_m + step_s * slip_mps);
  step.shear_over_K = length(step.shear_m.x() / step.K_m.x(), step.shear_m.y() / step.K_m.y());
  const double most =
      std::max(shear_displacements_max, shear_lengths_max * step.length_m / step.K_m.minCoeff());
  if (step.shear_over_K > most) {
    step.shear_m *= most / step.shear_over_K;
    step.shear_over_K = most;
  }
  step.shear_rate_mps = (step.shear_m - before_m) / step_s;
}

double WheelSoil::slip_sinkage_m(const Step& step) const {
  const double u = step.slip.norm();
  return std::min(
      step.static_sinkage_m * (1 + soil_.slip_sinkage * u / (1 + u / slip_sinkage_half)),
      sinkage_max_radii * wheel_.radius_m);
}

// Traction from the mobilised shear. Damping acts on the rate of shear, which is zero in steady
// slip.
Vec2 WheelSoil::traction_n(const Step& step) const {
  const double limit_over_K = 2 * step.limit_n * mobilised_over_x(2 * step.shear_over_K);
  const Vec2 stiffness_npm = limit_over_K * step.K_m.cwiseInverse();
  const Vec2 force_n = -stiffness_npm.cwiseProduct(step.shear_m) -
                       wheel_.tangential_damping_nspm * step.shear_rate_mps;
  const double most = force_n.norm();
  return most > step.limit_n ? Vec2(force_n * (step.limit_n / most)) : force_n;
}

// Resistance of compaction, ploughing and the wheel's own flexing.
Vec2 WheelSoil::resistance_n(const Step& step) const {
  double against_n = wheel_.rolling_resistance * step.load_n, side_n = 0;
  if (!soil_.is_rigid) {
    against_n += pressure_.compaction_resistance_n(step.sinkage_m, step.load_n);
    // The wheel ploughs for the share of its travel that it does not roll. Travel for each metre
    // rolled is taken from the shear, which is steady; taken from the speeds it would act as a
    // stiff damper on slow wheels.
    const double onward = step.rolling_mobilised < 0 ? -1 : 1;
    const double travel = length(1 + onward * step.slip.x(), step.slip.y());
    const double skid = std::max(0.0, 1 - 1 / std::max(travel, 1e-3));
    if (skid > 0) against_n += skid * ploughing_n(wheel_.width_m, step.sinkage_m);
    const double side_m = 2 * pressure_.contact_length_m(step.sinkage_m);
    const double left_m = step.shear_m.y();
    const double pushed = -std::expm1(-std::abs(left_m) / step.K_m.y());
    side_n = -std::copysign(ploughing_n(side_m, step.sinkage_m) * pushed, left_m);
  }
  const double damping_n =
      wheel_.tangential_damping_nspm * (1 - std::abs(step.rolling_mobilised)) * step.ahead_mps;
  return {-against_n * step.rolling_mobilised - std::clamp(damping_n, -against_n, against_n),
          side_n};
}

WheelContactForces WheelSoil::forces(const WheelContactInput& input, double step_s,
                                     WheelContactState& state) const {
  WheelContactForces forces;
  forces.arm_m = shear_radius_m_;
  if (input.load_n <= 0) {
    state = {};
    return forces;
  }
  const Vec3& ahead_S = input.heading_S;
  const Vec3 left_S = input.normal_S.cross(ahead_S);
  const auto in_S = [&](const Vec2& v) -> Vec3 { return v.x() * ahead_S + v.y() * left_S; };

  Step step;
  step.load_n = input.load_n;
  step.static_sinkage_m = pressure_.static_sinkage_m(step.load_n);
  const double before_m = std::max(state.sinkage_m, step.static_sinkage_m);
  step.length_m = contact_length_m(before_m, step.load_n);
  step.ahead_mps = input.hub_velocity_S_mps.dot(ahead_S);
  step.left_mps = input.hub_velocity_S_mps.dot(left_S);
  step.rim_mps = input.rolling_speed_mps * shear_radius_m_ / wheel_.radius_m;
  if (!soil_.is_rigid) {
    step.curvature = 0.5 * (before_m + shear_radius_m_ - wheel_.radius_m) / shear_radius_m_;
  }

  forces.soil_shear_n = soil_shear_n(step.load_n, step.length_m);
  forces.traction_limit_n = step.limit_n = interface_ * forces.soil_shear_n;
  step.K_m = shear_modulus_m(step.limit_n);
  shear(step, {state.shear_S_m.dot(ahead_S), state.shear_S_m.dot(left_S)}, input.rolling_speed_mps,
        step_s);
  state.shear_S_m = in_S(step.shear_m);
  state.rolled_m = std::clamp(state.rolled_m + step.ahead_mps * step_s, -rolling_mobilised_m,
                              rolling_mobilised_m);
  step.rolling_mobilised = state.rolled_m / rolling_mobilised_m;
  // The shear from the rim's curvature in rolling without slip belongs to the static sinkage.
  step.slip = 2 / step.length_m * step.shear_m + Vec2(step.curvature * step.rolling_mobilised, 0);
  state.sinkage_m = step.sinkage_m = forces.sinkage_m = slip_sinkage_m(step);

  forces.traction_S_n = in_S(traction_n(step));
  forces.hub_force_S_n = in_S(resistance_n(step));
  return forces;
}

std::string soil_fault(const Soil& soil, const Wheel& wheel, double load_n, double gravity_mps2) {
  if (soil.is_rigid) return "";
  const double width_m = wheel.width_m, k_npm = soil.k_c + width_m * soil.k_phi;
  if (soil.has_bekker() && k_npm <= 0) {
    return fmt::format(
        "the soil {} cannot carry a wheel {} m wide: k_c + b k_phi is {:.4g}, must be above 0, "
        "which takes a width of more than {:.4g} m",
        soil.name, width_m, k_npm, -soil.k_c / soil.k_phi);
  }
  if (!soil.has_bekker() && soil.cohesion_pa <= 0 && soil.friction_rad <= 0) {
    return fmt::format("the soil {} has neither cohesion nor friction: it carries nothing",
                       soil.name);
  }
  const PressureSinkage law(soil, wheel.radius_m, width_m, gravity_mps2);
  const double most_n = law.load_n(wheel.radius_m);
  if (load_n < most_n) return "";
  return fmt::format(
      "the soil {} does not bear its wheels: with {:.4g} N each they sink to the axle, which "
      "{:.4g} N do",
      soil.name, load_n, most_n);
}

double normal_load_n(const Wheel& wheel, double penetration_m, double closing_mps) {
  if (penetration_m <= 0) return 0;
  return std::max(
      0.0, wheel.normal_stiffness_npm * penetration_m + wheel.normal_damping_nspm * closing_mps);
}

double slip_ratio(double hub_speed_mps, double rolling_speed_mps) {
  const double hub = std::abs(hub_speed_mps), rolling = std::abs(rolling_speed_mps);
  if (hub < 1e-3 && rolling < 1e-3) return not_modelled;
  if (rolling == 0) return -1;  // locked, whichever direction it slides in
  const double along = hub_speed_mps * (rolling_speed_mps < 0 ? -1 : 1);  // in the rim's direction
  if (rolling >= along) return std::max(-1.0, std::min(1.0, 1 - along / rolling));
  return rolling / along - 1;
}

}  // namespace lsos
