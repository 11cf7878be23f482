// How deep a rigid wheel sinks under its load, and the work that making its rut takes. One law a
// soil: sinkage and resistance always come from the same one.
//
//   Bekker (1969), where k_c, k_phi, n are known: p = (k_c/b + k_phi) z^n.
//   Terzaghi (1943), where they are not: p = c N_c + gamma z N_q + gamma B N_gamma / 2 over the
//   area b l below the wheel; B is the smaller of width b and contact length l.
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

// One wheel shape on one soil; what does not change from step to step is worked out once.
class PressureSinkage {
 public:
  // `gravity_mps2`: for the soil's weight. Radius and width of the wheel in m, > 0.
  PressureSinkage(const Soil& soil, double radius_m, double width_m, double gravity_mps2);

  // Depth at which the law carries the load, 0..radius. Bekker:
  // z = (3 W / ((3 - n)(k_c + b k_phi) sqrt(D)))^(2/(2n+1)).
  double static_sinkage_m(double load_n) const;

  // What the soil carries at a sinkage, N: the inverse of static_sinkage_m.
  double load_n(double sinkage_m) const;

  // Work of the law a metre of rut, N. Bekker: R_c = (k_c + b k_phi) z^(n+1) / (n+1).
  double rut_work_n(double sinkage_m) const;

  // The resistance of a wheel that carries `load_n` at this sinkage, which may be deeper than the
  // static one: soil that slip has loosened bears less at every depth, by the same factor, and
  // takes as much less work.
  double compaction_resistance_n(double sinkage_m, double load_n) const;

  // Area of the contact as seen from above over its width: l = sqrt(D z - z^2), from entry to the
  // lowest point, because the rut does not spring back. Deeper than its axle a wheel has l = R.
  double contact_length_m(double sinkage_m) const;

 private:
  double terzaghi_pa(double sinkage_m) const;

  Soil soil_;
  double diameter_m_ = 0, width_m_ = 0;
  double unit_weight_npm3_ = 0;
  double k_npm_ = 0;  // k_c + b k_phi
  BearingFactors factors_;
  double exponent_ = 0, scale_ = 0;  // z = (scale W)^exponent
  double resistance_per_root_ = 0;   // R_c / (W sqrt(z/D))
};

}  // namespace lsos
