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

// Least share of the load that the normal force carries upwards, cos(theta) + m sin(theta): a
// locked wheel that has dug itself in presses on the soil ahead no harder than this allows.
constexpr double carried_min = 0.3;

// Slip beyond which a trench grows no deeper: at four layers the soil falls back in as fast as the
// grousers carry it away. Measured: 16 mm at slip 0.9 with a layer of 2.9 mm.
constexpr double digging_slip_max = 0.8;

// Greatest thrust without slip of the shear radius over the compaction resistance: at 1 a driven
// wheel would roll on level ground without it.
constexpr double curvature_thrust_max = 0.95;

// Greatest curvature: wheels sunk to the axle are beyond the model.
constexpr double curvature_max = 0.9;

// A wheel that turns slower than this stands: rounding must not roll a parked rover off its anchor.
constexpr double still_mps = 1e-5;

// Flattening beyond which the carcass is no model of a wheel, m: half of its radius.
double deflection_max_m(const Wheel& wheel) { return wheel.radius_m / 2; }

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
  wedge_ = std::tan(std::numbers::pi / 4 + soil.friction_rad / 2);
  const double h = wheel.grouser_height_m, b = wheel.width_m;
  double g = 0;
  if (!soil.is_rigid && h > 0) {
    g = std::min(1.0, wheel.grouser_count * h * wedge_ / (2 * std::numbers::pi * wheel.radius_m));
  }
  layer_m_ = g * h;
  shear_radius_m_ = wheel.radius_m + layer_m_;
  const double f = soil.is_rigid ? 1 : wheel.interface_friction_ratio;
  rim_friction_ = f * (1 - g) + g;
  rim_adhesion_ = f * f * (1 - g) + g;
  rim_modulus_ = rim_friction_ / (g + (1 - g) / f);  // rim: strength f, K f^2, so stiffness 1/f
  const double sides = h > 0 ? 0.64 * h / b * std::atan(b / h) : 0;
  shear_per_area_pa_ = soil.cohesion_pa * (1 + g * 2 * h / b);
  shear_per_load_ = std::tan(soil.friction_rad) * (1 + g * sides);
  wall_friction_ = std::tan(soil.friction_rad);
}

double WheelSoil::soil_shear_n(double load_n, double contact_length_m) const {
  return wheel_.width_m * contact_length_m * shear_per_area_pa_ + load_n * shear_per_load_;
}

double WheelSoil::traction_limit_n(double load_n, double contact_length_m) const {
  return rim_adhesion_ * wheel_.width_m * contact_length_m * shear_per_area_pa_ +
         rim_friction_ * load_n * shear_per_load_;
}

double WheelSoil::ploughing_n(double width_m, double depth_m) const {
  const double wide_m = width_m + 0.5 * wedge_ * depth_m;
  return wide_m * depth_m * wedge_ *
         (0.5 * unit_weight_npm3_ * depth_m * wedge_ + 2 * soil_.cohesion_pa);
}

// Quantities of one step of one wheel in the plane of the ground: x along its heading, y to its
// left.
struct WheelSoil::Step {
  double load_n = 0, static_sinkage_m = 0;
  double deflection_m = 0;                // of the carcass
  double length_m = 0, rim_length_m = 0;  // contact of the soil body, and of the rim
  double ahead_mps = 0, left_mps = 0;     // velocity of the hub
  double rim_mps = 0;    // speed of the soil body's surface, relative to the hub, backwards
  double curvature = 0;  // slip that would shear as much as the rim's curvature does, 2 j0/l
  Vec2 shear_m = Vec2::Zero();
  double braked = 0;                     // share of the shear that brakes, 0..1
  double soil_limit_n = 0, limit_n = 0;  // H_max; the same of this contact
  Vec2 K_m = Vec2::Zero();
  double shear_over_K = 0;
  double rolling_mobilised = 0;  // mobilised share of the rolling resistance, -1..1
  // Excess travel for each metre that the shear radius rolls; c / (1 - c) at the rolling radius.
  Vec2 slip = Vec2::Zero();
  double sinkage_m = 0;
  double tilt = 0, cos_tilt = 1;  // tan and cos of theta; tilt has the sign of the travel
  double normal_over_load = 1;    // N/W
  Vec2 traction_n = Vec2::Zero();
};

// Contact of a wheel or soil body of this radius. On ground that the wheel hardly marks, its spring
// against the ground flattens it.
double WheelSoil::contact_length_m(double sinkage_m, const Step& step, double radius_m) const {
  const double k = wheel_.normal_stiffness_npm, d = step.deflection_m;
  const double z = std::min(std::max(sinkage_m + d, k > 0 ? step.load_n / k : 0), radius_m);
  return std::sqrt(z * (2 * radius_m - z)) + std::sqrt(d * (2 * radius_m - d));
}

double WheelSoil::curvature(double sinkage_m, const Step& step) const {
  if (soil_.is_rigid || sinkage_m <= 0) return 0;
  const auto j0_m = [](double z, double contact_m) { return 2.0 / 3 * z * z / contact_m; };
  const double static_m = std::min(step.static_sinkage_m, wheel_.radius_m);
  const double contact_m = contact_length_m(static_m, step, wheel_.radius_m);
  const double thrust_n = traction_limit_n(step.load_n, contact_m);
  const double K_m =
      std::max(rim_modulus_ * soil_.shear_modulus_x_m, thrust_n / wheel_.tangential_stiffness_npm);
  const double resistance_n =
      pressure_.compaction_resistance_n(static_m, step.load_n, step.deflection_m);
  // 2 j0/K = 2 q/(1 - 2 q/3) mobilises a share q of the strength, or a little less.
  const double q = std::min(1.0, curvature_thrust_max * resistance_n / thrust_n);
  const double allowed = std::min(1.0, K_m * q / (1 - 2 * q / 3) / j0_m(static_m, contact_m));
  return std::min(curvature_max, 2 * allowed * j0_m(sinkage_m, step.rim_length_m) / step.length_m);
}

// Slip shears the soil and rolling brings fresh soil under the rim:
//  dj/dt = slip speed - 2 |r_s w| j / l,
// integrated implicitly. In steady rolling the balance of both gives the mean displacement j.
void WheelSoil::shear(Step& step, const Vec2& before_m, double step_s) const {
  const double rolled_mps = std::max(0.0, std::abs(step.rim_mps) - still_mps);
  const double fresh = 1 / (1 + 2 * rolled_mps * step_s / step.length_m);
  const Vec2 slip_mps(step.ahead_mps * (1 - step.curvature) - step.rim_mps, step.left_mps);
  step.shear_m = fresh * (before_m + step_s * slip_mps);
}

// Strength and shear modulus of the contact, between those of a driven rim and, where shear
// brakes, those of the soil; then the limit beyond which the anchor is dragged along.
void WheelSoil::mobilise(Step& step) const {
  const double sheared_m = step.shear_m.norm();
  if (sheared_m > 0) {
    step.braked = std::clamp(step.shear_m.x() * step.rolling_mobilised / sheared_m, 0.0, 1.0);
  }
  step.soil_limit_n = soil_shear_n(step.load_n, step.rim_length_m);
  const double driven_n = traction_limit_n(step.load_n, step.rim_length_m);
  step.limit_n = driven_n + step.braked * (step.soil_limit_n - driven_n);
  const double modulus = rim_modulus_ + step.braked * (1 - rim_modulus_);
  const double wheel_m = step.limit_n / wheel_.tangential_stiffness_npm;
  step.K_m = {std::max(modulus * soil_.shear_modulus_x_m, wheel_m),
              std::max(modulus * soil_.shear_modulus_y_m, wheel_m)};
  step.shear_over_K = length(step.shear_m.x() / step.K_m.x(), step.shear_m.y() / step.K_m.y());
  const double most =
      std::max(shear_displacements_max, shear_lengths_max * step.length_m / step.K_m.minCoeff());
  if (step.shear_over_K > most) {
    step.shear_m *= most / step.shear_over_K;
    step.shear_over_K = most;
  }
}

double WheelSoil::slip_sinkage_m(const Step& step) const {
  const double u = 2 / step.length_m * step.shear_m.norm();
  return std::min(
      step.static_sinkage_m * (1 + soil_.slip_sinkage * u / (1 + u / slip_sinkage_half)),
      sinkage_max_radii * wheel_.radius_m);
}

// Traction from the mobilised shear under the load. Damping acts on the rate of shear, which is
// zero in steady slip.
Vec2 WheelSoil::traction_n(const Step& step, const Vec2& before_m, double step_s) const {
  const double limit_over_K = 2 * step.limit_n * mobilised_over_x(2 * step.shear_over_K);
  const Vec2 stiffness_npm = limit_over_K * step.K_m.cwiseInverse();
  const Vec2 rate_mps = (step.shear_m - before_m) / step_s;
  const Vec2 force_n =
      -stiffness_npm.cwiseProduct(step.shear_m) - wheel_.tangential_damping_nspm * rate_mps;
  const double most = force_n.norm();
  return most > step.limit_n ? Vec2(force_n * (step.limit_n / most)) : force_n;
}

// Balance of the load: traction that drives carries a part of it, traction that brakes adds to it.
// Traction grows and falls with the force N on the rim.
void WheelSoil::press(Step& step) const {
  if (soil_.is_rigid) return;
  step.tilt = pressure_.compaction_resistance_n(step.sinkage_m, step.load_n, step.deflection_m) /
              step.load_n * step.rolling_mobilised;
  step.cos_tilt = 1 / std::sqrt(1 + step.tilt * step.tilt);
  const double carried = step.cos_tilt * (1 + step.tilt * step.traction_n.x() / step.load_n);
  step.normal_over_load = 1 / std::max(carried_min, carried);
  step.traction_n *= step.normal_over_load;
}

// Share of the side wall's friction that acts along the heading, -1..1, from the velocity of the
// wall at half the depth over the speed of the rim.
double WheelSoil::rubbing(const Step& step) const {
  const double diameter_m = 2 * shear_radius_m_;
  const double along = step.slip.x() + step.rolling_mobilised * step.sinkage_m / diameter_m;
  return along / length(along, step.rim_length_m / diameter_m);
}

// Depth of the trench that grousers dig, see the file comment.
double WheelSoil::trench_m(const Step& step) const {
  if (layer_m_ <= 0) return 0;
  const double onward = step.rolling_mobilised < 0 ? -1 : 1;
  const double slip = std::clamp(-onward * step.slip.x(), 0.0, digging_slip_max);
  return layer_m_ * slip / (1 - slip);
}

// Resistance of compaction, ploughing and the wheel's own flexing. Compaction is the part along the
// ground of N, and the part of the traction that its tilt takes from the ground.
Vec2 WheelSoil::resistance_n(const Step& step) const {
  const double flexing_n = wheel_.rolling_resistance * step.load_n;
  const double compaction_n = std::abs(step.tilt) * step.load_n;
  double ahead_n = -flexing_n * step.rolling_mobilised, side_n = 0;
  if (!soil_.is_rigid) {
    ahead_n -= step.tilt * step.cos_tilt * step.normal_over_load * step.load_n +
               step.traction_n.x() * (1 - step.cos_tilt);
    // The wheel ploughs for the share of its travel that it does not roll. Travel for each metre
    // rolled is taken from the shear, which is steady; taken from the speeds it would act as a
    // stiff damper on slow wheels.
    const double onward = step.rolling_mobilised < 0 ? -1 : 1;
    const double travel = length(1 + onward * step.slip.x(), step.slip.y());
    const double skid = std::max(0.0, 1 - 1 / std::max(travel, 1e-3));
    if (skid > 0) {
      const double face_n = skid * ploughing_n(wheel_.width_m, step.sinkage_m);
      const double aside = std::abs(step.slip.y()) / std::max(travel, 1e-3);
      const double beyond_n = (1 - aside) * std::max(0.0, face_n - compaction_n) + aside * face_n;
      ahead_n -= beyond_n * step.rolling_mobilised;
    }
    const double left_m = step.shear_m.y();
    if (left_m != 0) {
      const double side_m = 2 * pressure_.contact_length_m(step.sinkage_m + step.deflection_m, 0);
      const double pushed = -std::expm1(-std::abs(left_m) / step.K_m.y());
      const double pushed_n = ploughing_n(side_m, step.sinkage_m) * pushed;
      side_n = -std::copysign(pushed_n, left_m);
      ahead_n -= wall_friction_ * pushed_n * rubbing(step);
    }
  }
  const double most_n = flexing_n + compaction_n;
  const double damping_n =
      wheel_.tangential_damping_nspm * (1 - std::abs(step.rolling_mobilised)) * step.ahead_mps;
  return {ahead_n - std::clamp(damping_n, -most_n, most_n), side_n};
}

WheelSoil::Step WheelSoil::standing(double load_n) const {
  Step step;
  step.load_n = load_n;
  step.deflection_m = std::min(load_n / wheel_.carcass_stiffness_npm, deflection_max_m(wheel_));
  step.static_sinkage_m = pressure_.static_sinkage_m(load_n, step.deflection_m);
  return step;
}

// Contact lengths of rim and soil body at this sinkage.
void WheelSoil::set_contact(Step& step, double sinkage_m) const {
  step.rim_length_m = contact_length_m(sinkage_m, step, wheel_.radius_m);
  step.length_m = contact_length_m(sinkage_m + layer_m_, step, shear_radius_m_);
  step.curvature = curvature(std::min(sinkage_m, wheel_.radius_m), step);
}

double WheelSoil::rolling_radius_m(double load_n) const {
  if (load_n <= 0) return shear_radius_m_;
  Step step = standing(load_n);
  set_contact(step, step.static_sinkage_m);  // without shear it sinks no deeper
  return shear_radius_m_ / (1 - step.curvature);
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

  Step step = standing(input.load_n);
  set_contact(step, std::max(state.sinkage_m, step.static_sinkage_m));
  step.ahead_mps = input.hub_velocity_S_mps.dot(ahead_S);
  step.left_mps = input.hub_velocity_S_mps.dot(left_S);
  step.rim_mps = input.rim_speed_mps;
  state.rolled_m = std::clamp(state.rolled_m + step.ahead_mps * step_s, -rolling_mobilised_m,
                              rolling_mobilised_m);
  step.rolling_mobilised = state.rolled_m / rolling_mobilised_m;

  const Vec2 shear_before_m(state.shear_S_m.dot(ahead_S), state.shear_S_m.dot(left_S));
  shear(step, shear_before_m, step_s);
  mobilise(step);
  state.shear_S_m = in_S(step.shear_m);
  step.slip = 2 / step.length_m * step.shear_m;
  step.slip.x() = (step.slip.x() + step.curvature * step.rolling_mobilised) / (1 - step.curvature);
  state.sinkage_m = step.sinkage_m = slip_sinkage_m(step);
  forces.sinkage_m = std::min(step.sinkage_m + trench_m(step), sinkage_max_radii * wheel_.radius_m);

  step.traction_n = traction_n(step, shear_before_m, step_s);
  press(step);
  forces.soil_shear_n = step.soil_limit_n * step.normal_over_load;
  forces.traction_limit_n = step.limit_n * step.normal_over_load;
  forces.traction_S_n = in_S(step.traction_n);
  forces.hub_force_S_n = in_S(resistance_n(step));
  return forces;
}

std::string carcass_fault(const Wheel& wheel, double load_n) {
  const double deflection_m = load_n / wheel.carcass_stiffness_npm;
  if (deflection_m <= deflection_max_m(wheel)) return "";
  return fmt::format(
      "its wheels bear {:.4g} N each, which flattens them by {:.3g} m, more than half of their "
      "radius: carcass_stiffness_npm is {:g}, must be at least {:.4g}",
      load_n, deflection_m, wheel.carcass_stiffness_npm, load_n / deflection_max_m(wheel));
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
