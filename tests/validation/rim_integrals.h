// Second method, exact and slow: stresses integrated over the rim as Wong and Reece (1967) do, with
// Bekker's pressure and Janosi and Hanamoto's shear. It knows no slip sinkage and no ploughing.
#pragma once

#include "terrain/spec/soil.h"
#include "vehicle/vehicle_config.h"

namespace lsos::validation {

struct RimIntegrals {
  double drawbar_pull_n = 0, torque_n_m = 0, sinkage_m = 0;
};

// Normal stress (k_c/b + k_phi)(r (cos theta - cos theta_1))^n rises from the entry angle theta_1
// to its maximum at theta_m = (0.4 + 0.2 |slip|) theta_1 and falls to zero at the lowest point;
// shear stress has j = r_s ((theta_1 - theta) - v/(r_s w) (sin theta_1 - sin theta)). Grousers
// shear at r_s, soil on soil, as WheelSoil has it; between them the rim slides with the wheel's
// friction ratio. theta_1 carries the load. The soil must have Bekker parameters; `slip`
// -0.99..0.99 by r_s.
RimIntegrals rim_integrals(const Soil& soil, const Wheel& wheel, double load_n, double slip);

}  // namespace lsos::validation
