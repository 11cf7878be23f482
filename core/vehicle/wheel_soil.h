// Forces between one wheel and the soil, at a single contact point.
//
// Reconstruction of the ROAMS wheel model (Sohl and Jain 2005, whose equations are not public): no
// torque at the contact, one compliance along the terrain normal and one with two degrees of
// freedom along the terrain, traction limited by the strength of the soil. In the following z is
// the sinkage, l the length of the contact, j the mean shear displacement of the soil under it, h
// the height of the grousers, and g, 0..1, the share of the rim that the soil wedges of the
// grousers fill.
//
//   Static sinkage z0 and compaction: the soil's one pressure law (pressure_sinkage.h).
//   Slip sinkage: z = z0 (1 + a u / (1 + u/2)), u = 2 |j - j0| / l, a = Soil::slip_sinkage, j0 the
//     shear of rolling without slip. Measured sinkages of a small wheel in sand under slip, skid
//     and slip angles fall on one curve over u, which is why shear, not slip, is the variable; the
//     form of the curve is a fit to them (VALIDATION.md).
//   Shear strength: H_max = f (b l c (1 + 2 g h/b) + W tan(phi) (1 + 0.64 g (h/b) atan(b/h)))
//     (Bekker 1969 as in Li and Bingham's LTV paper; g is added here). f is the interface
//     friction ratio on the rim between grousers, and 1 where grousers shear soil on soil.
//   Mobilised share: 1 - (1 - exp(-x))/x with x = 2 |j|/K (Janosi and Hanamoto 1961, integrated
//     along the contact as Wong did); K differs along and across the wheel. Soil and wheel act in
//     series and the softer one is taken: K is at least H_max / tangential stiffness.
//   Steady rolling: j = l/2 (r w - v (1 - z/(2R)))/(r w), Wong and Reece's j(theta) averaged over
//     the contact. Its part without slip, from the rim's curvature, is why a driven wheel at
//     zero slip nearly overcomes its own resistance.
//   Grousers: the soil between them turns with the wheel, so shear, its lever arm and the contact
//     length are those of the circle r + g h. Li and Bingham's factor N_g, for several grousers, is
//     left out.
//   Ploughing: passive earth pressure (Rankine 1857) on the rim's face, of width b, for the part of
//     its travel (sideways included) that the wheel does not roll; and on its side, taken as the
//     whole chord at full depth, while it is pushed sideways. It adds to the shear strength. The
//     two ends of the wedge widen the face by half the wedge's length. A wheel that rolls as far as
//     it travels presses soil down and pushes none ahead: it has compaction resistance only.
#pragma once

#include <string>

#include "base/archive.h"
#include "base/vector.h"
#include "vehicle/pressure_sinkage.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Travel over which rolling resistance builds up, because the soil ahead of the wheel yields a
// little before it flows. This also lets a standing wheel resist being pushed.
inline constexpr double rolling_mobilised_m = 0.005;

// State of the contact between steps. It holds a parked rover on a slope without creep.
struct WheelContactState {
  Vec3 shear_S_m = Vec3::Zero();  // shear displacement of the soil under the wheel, site frame
  double rolled_m = 0;  // travel into the soil ahead, -rolling_mobilised_m..rolling_mobilised_m
  double sinkage_m = 0;

  void archive(Archive& a) { LSOS_ARCHIVE(a, shear_S_m, rolled_m, sinkage_m); }
};

// State of a wheel relative to the ground in one step. Vectors are in the site frame.
struct WheelContactInput {
  double load_n = 0;             // along the normal
  Vec3 normal_S;                 // unit, out of the ground
  Vec3 heading_S;                // unit, rolling direction along the surface
  Vec3 hub_velocity_S_mps;       // velocity of the wheel's centre
  double rolling_speed_mps = 0;  // rim radius x spin
};

struct WheelContactForces {
  Vec3 traction_S_n = Vec3::Zero();   // shear force along the ground, applied `arm_m` below the hub
  Vec3 hub_force_S_n = Vec3::Zero();  // forces without torque: compaction, ploughing, flexing
  double arm_m = 0;                   // r + g h
  double sinkage_m = 0;
  double traction_limit_n = 0;  // H_max
  double soil_shear_n = 0;      // H_max / f
};

// One kind of wheel on one kind of soil.
class WheelSoil {
 public:
  WheelSoil(const Soil& soil, const Wheel& wheel, double gravity_mps2);

  // Advances `state` by one step of `step_s` and returns the forces. A load of 0 resets the state.
  WheelContactForces forces(const WheelContactInput& input, double step_s,
                            WheelContactState& state) const;

  // Greatest shear force along the terrain, N, over a contact of this length: that which the soil
  // bears, and that which reaches it through the rim (interface friction ratio). The latter limits
  // traction.
  double soil_shear_n(double load_n, double contact_length_m) const;
  double traction_limit_n(double load_n, double contact_length_m) const;
  // Passive earth pressure on a face of this width and depth, N.
  double ploughing_n(double width_m, double depth_m) const;
  const PressureSinkage& pressure() const { return pressure_; }

 private:
  struct Step;

  void shear(Step& step, const Vec2& before_m, double rolling_mps, double step_s) const;
  Vec2 shear_modulus_m(double limit_n) const;
  double slip_sinkage_m(const Step& step) const;
  Vec2 traction_n(const Step& step) const;
  Vec2 resistance_n(const Step& step) const;
  double contact_length_m(double sinkage_m, double load_n) const;

  Soil soil_;
  Wheel wheel_;
  PressureSinkage pressure_;
  double unit_weight_npm3_ = 0;
  double cover_ = 0;
  double shear_radius_m_ = 0;  // r + g h
  double interface_ = 1;
  double shear_per_area_pa_ = 0, shear_per_load_ = 0;
  double wedge_ = 0;  // tan(pi/4 + phi/2): root of K_p, and the wedge's length over its depth
};

// Reason why such a wheel with this load cannot stand on the soil ("k_c + b k_phi is ..., must be
// above 0", "they sink to the axle"), else "".
std::string soil_fault(const Soil& soil, const Wheel& wheel, double load_n, double gravity_mps2);

// Normal force of the wheel's spring and damper, N, at least 0. `penetration_m` is the depth of the
// rim below the surface along the normal, `closing_mps` its rate.
double normal_load_n(const Wheel& wheel, double penetration_m, double closing_mps);

// Longitudinal slip, -1..1: 1 - v/(r w) when driving, r w/v - 1 when braking; NaN when both speeds
// are below 1 mm/s.
double slip_ratio(double hub_speed_mps, double rolling_speed_mps);

}  // namespace lsos
