#include "validation/rim_integrals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos::validation {

namespace {

constexpr double peak_at_rest = 0.4, peak_by_slip = 0.2;  // Wong and Reece: c_1, c_2 of sands
constexpr int pieces = 200;

struct Sums {
  double load_n = 0, pull_n = 0, torque_n_m = 0;
};

struct Rim {
  const Soil& soil;
  const Wheel& wheel;
  double layer = 0;  // share of the rim that soil wedges fill
  double shear_radius_m = 0;
  double travel = 1;  // v/(r_s w)
  double peak = 0;    // theta_m/theta_1

  Sums integrate(double entry_rad) const {
    const double r = wheel.radius_m, b = wheel.width_m, step_rad = entry_rad / pieces;
    const double k = soil.k_c / b + soil.k_phi, peak_rad = peak * entry_rad;
    const double f = wheel.interface_friction_ratio;
    const double friction = (f * (1 - layer) + layer) * std::tan(soil.friction_rad);
    const double adhesion_pa = (f * f * (1 - layer) + layer) * soil.cohesion_pa;
    Sums sums;
    for (int i = 0; i < pieces; ++i) {
      const double at = (i + 0.5) * step_rad;
      const double same = at > peak_rad ? at : entry_rad - at * (entry_rad - peak_rad) / peak_rad;
      const double depth_m = std::max(0.0, r * (std::cos(same) - std::cos(entry_rad)));
      const double normal_pa = k * std::pow(depth_m, soil.n);
      const double j_m =
          shear_radius_m * ((entry_rad - at) - travel * (std::sin(entry_rad) - std::sin(at)));
      const double strength_pa = adhesion_pa + normal_pa * friction;
      const double shear_pa =
          std::copysign(strength_pa * -std::expm1(-std::abs(j_m) / soil.shear_modulus_x_m), j_m);
      const double area_m2 = b * r * step_rad;
      sums.load_n += area_m2 * (normal_pa * std::cos(at) + shear_pa * std::sin(at));
      sums.pull_n += area_m2 * (shear_pa * std::cos(at) - normal_pa * std::sin(at));
      sums.torque_n_m += area_m2 * shear_radius_m * shear_pa;
    }
    return sums;
  }
};

}  // namespace

RimIntegrals rim_integrals(const Soil& soil, const Wheel& wheel, double load_n, double slip) {
  const double wedge = std::tan(std::numbers::pi / 4 + soil.friction_rad / 2);
  Rim rim{soil, wheel};
  rim.layer = std::min(1.0, wheel.grouser_count * wheel.grouser_height_m * wedge /
                                (2 * std::numbers::pi * wheel.radius_m));
  rim.shear_radius_m = wheel.radius_m + rim.layer * wheel.grouser_height_m;
  rim.travel = slip >= 0 ? 1 - slip : 1 / (1 + slip);
  rim.peak = peak_at_rest + peak_by_slip * std::abs(slip);
  double low = 0, high = std::numbers::pi / 2;
  for (int i = 0; i < 60; ++i) {
    const double entry_rad = (low + high) / 2;
    (rim.integrate(entry_rad).load_n < load_n ? low : high) = entry_rad;
  }
  const Sums sums = rim.integrate(high);
  return {sums.pull_n, sums.torque_n_m, wheel.radius_m * (1 - std::cos(high))};
}

}  // namespace lsos::validation
