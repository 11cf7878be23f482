// What the ground is made of.
#pragma once

#include <string>

namespace lsos {

// Pressure-sinkage (Bekker 1969: p = (k_c/b + k_phi) z^n) and shear strength (Mohr-Coulomb) of a
// soil, with the displacement over which shear builds up (Janosi and Hanamoto 1961).
struct Soil {
  std::string name;
  double k_c = 0;              // N/m^(n+1)
  double k_phi = 0;            // N/m^(n+2), > 0
  double n = 1;                // 0.2..2
  double cohesion_pa = 0;      // >= 0
  double friction_rad = 0;     // internal friction angle, 0..pi/2
  double density_kgpm3 = 0;    // bulk
  double shear_modulus_m = 0;  // K, > 0
};

}  // namespace lsos
