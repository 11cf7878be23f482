#include "vehicle/pressure_sinkage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

BearingFactors bearing_factors(double friction_rad) {
  if (friction_rad < 1e-6) return {1.5 * std::numbers::pi + 1, 1, 0};
  const double t = std::tan(friction_rad);
  const double c = std::cos(std::numbers::pi / 4 + friction_rad / 2);
  BearingFactors f;
  f.N_q = std::exp((1.5 * std::numbers::pi - friction_rad) * t) / (2 * c * c);
  f.N_c = (f.N_q - 1) / t;
  f.N_gamma = 2 * (f.N_q + 1) * t / (1 + 0.4 * std::sin(4 * friction_rad));
  return f;
}

PressureSinkage::PressureSinkage(const Soil& soil, double radius_m, double width_m,
                                 double gravity_mps2)
    : soil_(soil),
      diameter_m_(2 * radius_m),
      width_m_(width_m),
      unit_weight_npm3_(soil.density_kgpm3 * gravity_mps2),
      k_npm_(soil.k_c + width_m * soil.k_phi),
      factors_(bearing_factors(soil.friction_rad)) {
  const double n = soil.n;
  scale_ = 3 / ((3 - n) * k_npm_ * std::sqrt(diameter_m_));
  exponent_ = 2 / (2 * n + 1);
  resistance_per_root_ = 3 / ((3 - n) * (n + 1));
}

double PressureSinkage::contact_length_m(double sinkage_m, double deflection_m) const {
  const double z = std::min(sinkage_m + deflection_m, diameter_m_ / 2);
  const double entry_m = std::sqrt(z * (diameter_m_ - z));
  if (deflection_m <= 0) return entry_m;
  return entry_m + std::sqrt(deflection_m * (diameter_m_ - deflection_m));
}

double PressureSinkage::terzaghi_pa(double sinkage_m, double contact_m) const {
  const double B = std::min(width_m_, contact_m);
  return soil_.cohesion_pa * factors_.N_c + unit_weight_npm3_ * sinkage_m * factors_.N_q +
         unit_weight_npm3_ * B * factors_.N_gamma / 2;
}

double PressureSinkage::load_n(double sinkage_m, double deflection_m) const {
  if (soil_.is_rigid || sinkage_m <= 0) return 0;
  if (!soil_.has_bekker()) {
    const double contact_m = contact_length_m(sinkage_m, deflection_m);
    return width_m_ * contact_m * terzaghi_pa(sinkage_m, contact_m);
  }
  if (deflection_m <= 0) return std::pow(sinkage_m, 1 / exponent_) / scale_;
  return k_npm_ * std::pow(sinkage_m, soil_.n) * carrying_length_m(sinkage_m, deflection_m);
}

// Length of a level plate at the same depth that carries as much as the wheel does.
double PressureSinkage::carrying_length_m(double sinkage_m, double deflection_m) const {
  const double flat = std::sqrt(deflection_m), entry = std::sqrt(sinkage_m + deflection_m);
  const double round = 1 - soil_.n / 3 * (entry + 2 * flat) / (entry + flat);
  return std::sqrt(diameter_m_) * (2 * flat + round * (entry - flat));
}

// Newton's method in the logarithm of the load, which rises with that of z at a slope between n and
// n + 1/2. A rigid wheel and a level plate, each of which is but a part of this one, sink deeper:
// the lesser of both depths is near the solution.
double PressureSinkage::yielding_sinkage_m(double load_n, double deflection_m) const {
  const double deepest_m = diameter_m_ / 2;
  const double plate_n = 2 * k_npm_ * std::sqrt(diameter_m_ * deflection_m);  // at a depth of 1 m
  double z =
      std::min(std::pow(scale_ * load_n, exponent_), std::pow(load_n / plate_n, 1 / soil_.n));
  for (int i = 0; i < 20; ++i) {
    const double length_m = carrying_length_m(z, deflection_m);
    const double carried_n = k_npm_ * std::pow(z, soil_.n) * length_m;
    const double slope = soil_.n + (1 - soil_.n / 3) * std::sqrt(diameter_m_) * z /
                                       (2 * std::sqrt(z + deflection_m) * length_m);
    const double change = std::max(-0.5, (load_n / carried_n - 1) / slope);
    z *= 1 + change;
    if (std::abs(change) < 1e-9) break;
  }
  return std::min(z, deepest_m);
}

double PressureSinkage::static_sinkage_m(double load_n, double deflection_m) const {
  if (soil_.is_rigid || load_n <= 0) return 0;
  const double deepest_m = diameter_m_ / 2;
  if (soil_.has_bekker()) {
    if (deflection_m > 0) return yielding_sinkage_m(load_n, deflection_m);
    return std::min(std::pow(scale_ * load_n, exponent_), deepest_m);
  }
  if (deflection_m > 0) {  // bears without sinking
    const double contact_m = contact_length_m(0, deflection_m);
    if (width_m_ * contact_m * terzaghi_pa(0, contact_m) >= load_n) return 0;
  }
  // Newton's method in y = sqrt(z), in which the load is nearly a cubic with positive terms. A
  // single term carries the whole load only at a greater depth, so the least of those depths bounds
  // the solution from above, and from there the iteration descends to it.
  const double b_root_D = width_m_ * std::sqrt(diameter_m_);
  const double by_c = load_n / (b_root_D * soil_.cohesion_pa * factors_.N_c);
  const double by_q = std::cbrt(load_n / (b_root_D * unit_weight_npm3_ * factors_.N_q));
  double y = std::min({by_c, by_q, std::sqrt(deepest_m)});
  for (int i = 0; i < 20; ++i) {
    const double z = y * y, off_n = this->load_n(z, deflection_m) - load_n;
    const double higher_m = z * (1 + 1e-4);
    const double slope =
        (this->load_n(higher_m, deflection_m) - off_n - load_n) / (std::sqrt(higher_m) - y);
    const double next = std::clamp(y - off_n / slope, 0.5 * y, std::sqrt(deepest_m));
    if (std::abs(next - y) < 1e-9 * y) return next * next;
    y = next;
  }
  return y * y;
}

double PressureSinkage::rut_work_n(double sinkage_m, double deflection_m) const {
  if (soil_.is_rigid || sinkage_m <= 0) return 0;
  const double z = sinkage_m;
  if (soil_.has_bekker()) return k_npm_ * std::pow(z, soil_.n + 1) / (soil_.n + 1);
  // Integral of min(b, l(z)) over the depth: half a segment of the wheel's circle while l is below
  // b.
  const double R = diameter_m_ / 2;
  const double b = width_m_;
  const double wide_m = b < R ? R - std::sqrt(R * R - b * b) : R;  // depth at which l reaches b
  const double lower_m = std::min(z, wide_m);
  const double segment_m2 =
      (R * R * std::acos(1 - lower_m / R) - (R - lower_m) * contact_length_m(lower_m)) / 2;
  double B_dz_m2 = segment_m2 + std::min(b, R) * (z - lower_m);
  if (deflection_m > 0) {  // Simpson's rule: the contact is long from the first touch on
    const auto B = [&](double depth_m) {
      return std::min(b, contact_length_m(depth_m, deflection_m));
    };
    B_dz_m2 = (B(0) + 4 * B(z / 2) + B(z)) * z / 6;
  }
  return b * (soil_.cohesion_pa * factors_.N_c * z + unit_weight_npm3_ * factors_.N_q * z * z / 2 +
              unit_weight_npm3_ * factors_.N_gamma * B_dz_m2 / 2);
}

double PressureSinkage::compaction_resistance_n(double sinkage_m, double load_n,
                                                double deflection_m) const {
  if (soil_.is_rigid || sinkage_m <= 0) return 0;
  if (!soil_.has_bekker()) {
    return load_n * rut_work_n(sinkage_m, deflection_m) / this->load_n(sinkage_m, deflection_m);
  }
  if (deflection_m <= 0) return load_n * resistance_per_root_ * std::sqrt(sinkage_m / diameter_m_);
  return load_n * sinkage_m / ((soil_.n + 1) * carrying_length_m(sinkage_m, deflection_m));
}

}  // namespace lsos
