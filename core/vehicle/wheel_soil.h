// Forces between one wheel and the soil, at a single contact point.
//
// A reconstruction of the ROAMS wheel model (Sohl and Jain 2005, whose equations are not public):
// no torque at the contact, one compliance along the terrain normal and one with two degrees of
// freedom along the terrain, traction limited by the strength of the soil.
//   Sinkage and its resistance: one pressure law, p = (k_c/b + k_phi) z^n (Bekker 1969).
//   Traction: Mohr-Coulomb, H_max = b l c + W tan(phi), approached with shear displacement as
//   Janosi and Hanamoto (1961) found. In steady rolling at slip s it is Wong's integral along the
//   contact, H = H_max (1 - K/(s l) (1 - exp(-s l/K))); the contact's memory, the mean shear
//   displacement j = s l/2, carries the same curve through starts, stops and standing still.
#pragma once

#include "base/archive.h"
#include "base/vector.h"
#include "terrain/soil.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Static sinkage of a rigid wheel, m: the depth at which the pressure law carries `load_n`
// (Bekker 1969): z = (3 W / ((3 - n)(k_c + b k_phi) sqrt(D)))^(2/(2n+1)).
double sinkage_m(const Soil& soil, const Wheel& wheel, double load_n);

// Work of the pressure law a metre of rut, N: R_c = (k_c + b k_phi) z^(n+1) / (n+1).
double compaction_resistance_n(const Soil& soil, const Wheel& wheel, double sinkage_m);

// Length of the contact between rim and soil, m: l = sqrt(D z - z^2), from entry to the lowest
// point, because the rut does not spring back.
double contact_length_m(const Wheel& wheel, double sinkage_m);

// Most that the soil can bear along the terrain, N.
double traction_limit_n(const Soil& soil, const Wheel& wheel, double load_n,
                        double contact_length_m);

// What the contact remembers: how far the soil under the wheel is sheared, in the site frame.
// This holds a parked rover on a slope without creeping.
struct WheelContactState {
  Vec3 shear_S_m = Vec3::Zero();

  void archive(Archive& a) { a(shear_S_m); }
};

// How the wheel meets the ground at this step. Vectors in the site frame.
struct WheelContactInput {
  double penetration_m = 0;      // of the rim into the surface, along the normal; > 0 touches
  Vec3 normal_S;                 // unit, out of the ground
  Vec3 heading_S;                // unit, rolling direction along the surface
  Vec3 rim_velocity_S_mps;       // of the wheel's material at the contact point
  Vec3 hub_velocity_S_mps;       // of the wheel's centre
  double rolling_speed_mps = 0;  // radius x spin
};

struct WheelContactForces {
  Vec3 at_contact_S_n = Vec3::Zero();  // normal force and traction, at the contact point
  Vec3 at_hub_S_n = Vec3::Zero();      // compaction resistance: radial pressure, no torque
  double load_n = 0;
  double sinkage_m = 0;
};

// One step of `step_s`; changes `state`.
WheelContactForces contact_forces(const Soil& soil, const Wheel& wheel,
                                  const WheelContactInput& input, double step_s,
                                  WheelContactState& state);

// Longitudinal slip, -1..1: 1 - v/(r w) when driving, r w/v - 1 when braking; NaN when both are
// slower than 1 mm/s.
double slip_ratio(double hub_speed_mps, double rolling_speed_mps);

}  // namespace lsos
