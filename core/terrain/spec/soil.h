// What the ground is made of.
#pragma once

#include <string>

namespace lsos {

// Parameters of a soil under pressure and shear. Its pressure-sinkage law is Bekker's (1969),
// p = (k_c/b + k_phi) z^n, where k_phi is given, and Terzaghi's bearing capacity (1943) where not.
struct Soil {
  std::string name = {};
  std::string doc = {};  // what it is and where its numbers are from; "": not said
  double k_c = 0;        // N/m^(n+1)
  double k_phi = 0;      // N/m^(n+2); 0: no Bekker parameters are known, Terzaghi's law is used
  double n = 1;          // 0.2..2
  double cohesion_pa = 0;
  double friction_rad = 0;       // internal friction angle, 0..pi/2; on rock: of wheel and rock
  double density_kgpm3 = 0;      // bulk
  double shear_modulus_x_m = 0;  // Janosi and Hanamoto's K (1961) along the wheel, > 0
  double shear_modulus_y_m = 0;  // the same across it, > 0
  // Growth of sinkage with shear under the wheel, a share of the static sinkage for each contact
  // length of slip; see wheel_soil.h. Where nobody measured it: the geometric mean of three soils,
  // 1.8, 2.9 and 3.6 (vehicle/VALIDATION.md).
  double slip_sinkage = 2.7;
  bool is_rigid = false;  // rock: wheels do not sink

  bool has_bekker() const { return k_phi > 0; }
};

}  // namespace lsos
