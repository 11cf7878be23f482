// Static sinkage of a wheel under its load, and the work that compacting its rut takes. Sinkage and
// resistance always come from the same pressure law of the soil:
//
//   Bekker (1969), where k_c, k_phi, n are known: p = (k_c/b + k_phi) z^n.
//   Terzaghi (1943), where they are not: p = c N_c + gamma z N_q + gamma B N_gamma / 2 over the
//   area b l below the wheel; B is the smaller of width b and contact length l.
//
// A wheel whose carcass yields by d under its load is level over 2 sqrt(D d) and round ahead of
// that (Bekker 1969, elastic wheel); it enters the soil at height z + d over its lowest part, so
// l = sqrt(D (z + d)) + sqrt(D d). A rigid wheel has d = 0.
#pragma once

#include <string>

#include "terrain/spec/soil.h"

namespace lsos {

// Terzaghi's bearing capacity factors for a friction angle 0..1.4 rad. N_c and N_q: Terzaghi
// (1943), agree with his table to its last digit. N_gamma: Coduto's fit, within 10 % of the table
// from 25 to 40 deg.
struct BearingFactors {
  double N_c = 0, N_q = 0, N_gamma = 0;
};
BearingFactors bearing_factors(double friction_rad);

// One wheel shape on one soil; constants are computed once.
class PressureSinkage {
 public:
  // `gravity_mps2` gives the soil's weight. Radius and width of the wheel in m, > 0.
  PressureSinkage(const Soil& soil, double radius_m, double width_m, double gravity_mps2);

  // Depth at which the law carries the load, 0..radius. Bekker, for a rigid wheel:
  // z = (3 W / ((3 - n)(k_c + b k_phi) sqrt(D)))^(2/(2n+1)).
  // A wheel that yields may be borne without sinkage by Terzaghi's law.
  double static_sinkage_m(double load_n, double deflection_m = 0) const;

  // Load that the soil carries at a sinkage, N: the inverse of static_sinkage_m. Bekker, with x0 =
  // sqrt(D d), x1 = sqrt(D (z + d)) and k = k_c + b k_phi, the outline ahead of x0 a parabola:
  // W = k z^n (2 x0 + (1 - n/3 (x1 + 2 x0)/(x1 + x0)) (x1 - x0)), exact for n = 1.
  double load_n(double sinkage_m, double deflection_m = 0) const;

  // Work of the pressure law per metre of rut, N. Bekker: R_c = (k_c + b k_phi) z^(n+1) / (n+1).
  double rut_work_n(double sinkage_m, double deflection_m = 0) const;

  // Resistance of a wheel that carries `load_n` at this sinkage, which may be deeper than the
  // static one: soil loosened by slip bears less at every depth, by one factor, and takes less work
  // by the same factor.
  double compaction_resistance_n(double sinkage_m, double load_n, double deflection_m = 0) const;

  // Length of the contact, which is its area seen from above over its width: for a rigid wheel
  // l = sqrt(D z - z^2), from the entry to the lowest point, because the rut does not spring back;
  // l = R for wheels deeper than their axle.
  double contact_length_m(double sinkage_m, double deflection_m = 0) const;

 private:
  double terzaghi_pa(double sinkage_m, double contact_m) const;
  double carrying_length_m(double sinkage_m, double deflection_m) const;
  double yielding_sinkage_m(double load_n, double deflection_m) const;

  Soil soil_;
  double diameter_m_ = 0, width_m_ = 0;
  double unit_weight_npm3_ = 0;
  double k_npm_ = 0;  // k_c + b k_phi
  BearingFactors factors_;
  double exponent_ = 0, scale_ = 0;  // z = (scale W)^exponent
  double resistance_per_root_ = 0;   // R_c / (W sqrt(z/D))
};

}  // namespace lsos
