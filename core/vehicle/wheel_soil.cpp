#include "vehicle/wheel_soil.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// Below this hub speed the compaction resistance fades out linearly, so that it cannot push a
// standing wheel.
constexpr double resistance_fade_mps = 0.01;

// Shear displacement in units of K beyond which the anchor is dragged along, at 98 % of the limit.
constexpr double shear_displacements_max = 25;

// Share of the limit at mean shear displacement j, divided by j: (1 - (1 - e^-x)/x) / j, x = 2j/K.
double stress_share_pm(double j_m, double K) {
  const double x = 2 * j_m / K;
  if (x < 1e-4) return 1 / K;  // the limit; the next term is x/3 of it
  return (1 + std::expm1(-x) / x) / j_m;
}

}  // namespace

double sinkage_m(const Soil& soil, const Wheel& wheel, double load_n) {
  if (load_n <= 0) return 0;
  const double b = wheel.width_m, D = 2 * wheel.radius_m, n = soil.n;
  const double stiffness = (3 - n) * (soil.k_c + b * soil.k_phi) * std::sqrt(D);
  return std::min(std::pow(3 * load_n / stiffness, 2 / (2 * n + 1)), wheel.radius_m);
}

double compaction_resistance_n(const Soil& soil, const Wheel& wheel, double sinkage_m) {
  const double n = soil.n;
  return (soil.k_c + wheel.width_m * soil.k_phi) * std::pow(sinkage_m, n + 1) / (n + 1);
}

double contact_length_m(const Wheel& wheel, double sinkage_m) {
  return std::sqrt(sinkage_m * (2 * wheel.radius_m - sinkage_m));
}

double traction_limit_n(const Soil& soil, const Wheel& wheel, double load_n,
                        double contact_length_m) {
  return wheel.width_m * contact_length_m * soil.cohesion_pa + load_n * std::tan(soil.friction_rad);
}

WheelContactForces contact_forces(const Soil& soil, const Wheel& wheel,
                                  const WheelContactInput& input, double step_s,
                                  WheelContactState& state) {
  WheelContactForces forces;
  const Vec3& n = input.normal_S;
  if (input.penetration_m <= 0) {
    state.shear_S_m.setZero();
    return forces;
  }
  const double closing_mps = -input.rim_velocity_S_mps.dot(n);
  forces.load_n = std::max(0.0, wheel.normal_stiffness_npm * input.penetration_m +
                                    wheel.normal_damping_nspm * closing_mps);
  if (forces.load_n == 0) {
    state.shear_S_m.setZero();
    return forces;
  }
  forces.sinkage_m = sinkage_m(soil, wheel, forces.load_n);
  const double length_m = contact_length_m(wheel, forces.sinkage_m);
  const double limit_n = traction_limit_n(soil, wheel, forces.load_n, length_m);

  // Slip shears the soil; rolling brings fresh soil under the rim. In steady rolling at slip s the
  // balance of both leaves the mean displacement of the contact, s l / 2.
  const Vec3 slip_mps = input.rim_velocity_S_mps - input.rim_velocity_S_mps.dot(n) * n;
  Vec3 shear_m = state.shear_S_m - state.shear_S_m.dot(n) * n + slip_mps * step_s;
  shear_m /= 1 + 2 * std::abs(input.rolling_speed_mps) * step_s / length_m;
  const double K = soil.shear_modulus_m;
  double j_m = shear_m.norm();
  if (j_m > shear_displacements_max * K) {
    shear_m *= shear_displacements_max * K / j_m;
    j_m = shear_displacements_max * K;
  }
  state.shear_S_m = shear_m;

  Vec3 traction_n =
      -limit_n * stress_share_pm(j_m, K) * shear_m - wheel.tangential_damping_nspm * slip_mps;
  const double traction = traction_n.norm();
  if (traction > limit_n) traction_n *= limit_n / traction;
  forces.at_contact_S_n = forces.load_n * n + traction_n;

  const double hub_mps = input.hub_velocity_S_mps.dot(input.heading_S);
  forces.at_hub_S_n = -compaction_resistance_n(soil, wheel, forces.sinkage_m) * hub_mps /
                      std::max(std::abs(hub_mps), resistance_fade_mps) * input.heading_S;
  return forces;
}

double slip_ratio(double hub_speed_mps, double rolling_speed_mps) {
  const double hub = std::abs(hub_speed_mps), rolling = std::abs(rolling_speed_mps);
  if (hub < 1e-3 && rolling < 1e-3) return not_modelled;
  const double along = hub_speed_mps * (rolling_speed_mps < 0 ? -1 : 1);  // seen by the rim
  if (rolling >= along) return std::max(-1.0, std::min(1.0, 1 - along / rolling));
  return rolling / along - 1;
}

}  // namespace lsos
