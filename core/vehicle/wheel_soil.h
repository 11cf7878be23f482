// Forces between one wheel and the soil, at a single contact point.
//
// A reconstruction of the ROAMS wheel model (Sohl and Jain 2005, whose equations are not public):
// no torque at the contact, one compliance along the terrain normal and one with two degrees of
// freedom along the terrain, traction limited by the strength of the soil. With z the sinkage, l
// the length of the contact, j the mean displacement by which the soil under it is sheared:
//
//   Static sinkage z0 and compaction: the soil's one pressure law (pressure_sinkage.h).
//   Slip sinkage: z = z0 (1 + a u / (1 + u/2)), u = 2 |j - j0| / l, a = Soil::slip_sinkage, j0 the
//     shear of rolling without slip. Measured sinkages of a small wheel in sand under slip, skid
//     and slip angles fall on one curve over u, which is why shear, not slip, is the variable; the
//     curve's form is a fit to them (VALIDATION.md).
//   Shear strength: H_max = f (b l c (1 + 2 g h/b) + W tan(phi) (1 + 0.64 g (h/b) atan(b/h))), h
//     the grousers' height (Bekker 1969 as in Li and Bingham's LTV paper; g, see below, is ours);
//     f is the interface friction ratio of the rim between grousers and 1 where they shear soil on
//     soil.
//   Mobilised share: 1 - (1 - exp(-x))/x with x = 2 |j|/K (Janosi and Hanamoto 1961, integrated
//     along the contact as Wong did); K differs along and across the wheel. Of soil and wheel in
//     series the softer one is taken: K is at least H_max / tangential stiffness.
//   Steady rolling: j = l/2 (r w - v (1 - z/(2R)))/(r w): Wong and Reece's j(theta), averaged over
//     the contact. Its part without slip, from the rim's curvature, is why a driven wheel at zero
//     slip nearly carries its own resistance.
//   Grousers: between them soil turns with the wheel, so that shear, its arm and its length are
//     those of the circle r + g h, where g, 0..1, is how much of the rim their wedges fill.
//     Of the factors in Li and Bingham's formula N_g, for several grousers, is left out.
//   Ploughing: passive earth pressure (Rankine 1857) on the rim's face b for the part of its way
//     that the wheel does not roll, sideways travel included, and on its side, taken as the whole
//     chord at full depth, as it is pushed sideways. It comes on top of the shear strength. The
//     wedge's two ends widen the face by half its length. A wheel that rolls as far as it travels
//     presses soil down and pushes none ahead: its compaction resistance is all.
#pragma once

#include <string>

#include "base/archive.h"
#include "base/vector.h"
#include "vehicle/pressure_sinkage.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// The way over which resistance to rolling builds up, as the soil ahead of the wheel gives a
// little before it flows. It also keeps a standing wheel from being pushed.
inline constexpr double rolling_mobilised_m = 0.005;

// What the contact remembers. This holds a parked rover on a slope without creeping.
struct WheelContactState {
  Vec3 shear_S_m = Vec3::Zero();  // how far the soil under the wheel is sheared, site frame
  double rolled_m = 0;            // into the soil ahead, -rolling_mobilised_m..rolling_mobilised_m
  double sinkage_m = 0;

  void archive(Archive& a) { a(shear_S_m)(rolled_m)(sinkage_m); }
};

// How the wheel meets the ground at this step. Vectors in the site frame.
struct WheelContactInput {
  double load_n = 0;             // along the normal
  Vec3 normal_S;                 // unit, out of the ground
  Vec3 heading_S;                // unit, rolling direction along the surface
  Vec3 hub_velocity_S_mps;       // of the wheel's centre
  double rolling_speed_mps = 0;  // rim radius x spin
};

struct WheelContactForces {
  Vec3 traction_S_n = Vec3::Zero();  // shear along the ground, `arm_m` below the hub
  Vec3 at_hub_S_n = Vec3::Zero();    // what has no torque: compaction, ploughing, flexing
  double arm_m = 0;                  // r + g h
  double sinkage_m = 0;
  double traction_limit_n = 0;  // H_max
  double soil_shear_n = 0;      // H_max / f
};

// One kind of wheel on one kind of soil.
class WheelSoil {
 public:
  WheelSoil(const Soil& soil, const Wheel& wheel, double gravity_mps2);

  // One step of `step_s`; changes `state`. A load of 0 lets the contact forget.
  WheelContactForces forces(const WheelContactInput& input, double step_s,
                            WheelContactState& state) const;

  // Most shear along the terrain, N, over a contact of this length: what the soil bears, and what
  // reaches it through the rim (the interface friction ratio). The latter limits the traction.
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

// Why such a wheel with this load cannot stand on the soil ("k_c + b k_phi is ..., must be above
// 0", "it sinks to its axle"), else "".
std::string soil_fault(const Soil& soil, const Wheel& wheel, double load_n, double gravity_mps2);

// Force along the normal of the wheel's spring and damper, N, never pulling. `penetration_m` of
// the rim into the surface along the normal, `closing_mps` its growth.
double normal_load_n(const Wheel& wheel, double penetration_m, double closing_mps);

// Longitudinal slip, -1..1: 1 - v/(r w) when driving, r w/v - 1 when braking; NaN when both are
// slower than 1 mm/s.
double slip_ratio(double hub_speed_mps, double rolling_speed_mps);

}  // namespace lsos
