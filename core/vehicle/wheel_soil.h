// Forces between one wheel and the soil, at a single contact point.
//
// Reconstruction of the ROAMS wheel model (Sohl and Jain 2005, whose equations are not public): no
// torque at the contact, one compliance along the terrain normal and one with two degrees of
// freedom along the terrain, traction limited by the strength of the soil. In the following z is
// the sinkage of the rim, r its radius, b its width, W the load, h the height of the grousers, and
// g, 0..1, the share of the rim that the soil wedges of the grousers fill.
//
//   Shear radius: r_s = r + g h, that of the soil body which turns with the wheel, for j and torque
//     (Ding et al. 2011 have r + lambda_s h). The wedge before a grouser is h tan(pi/4 + phi/2)
//     long (passive slip line from its tip).
//   Rolling radius: r_s/(1 - c), by which slip is counted: v/w without net shear thrust. There the
//     curved rim alone shears the soil, which carries the wheel ahead of its shear radius by
//     c = 2 j0/l.
//   Flattening: the carcass yields by d = W / its stiffness, which lengthens the contact
//     (pressure_sinkage.h). Radius and torque arm stay those of the rigid wheel; a wheel that rolls
//     as its rim's circumference does would turn some d/3 short of that.
//   Static sinkage z0 and compaction: the soil's one pressure law (pressure_sinkage.h).
//   Slip sinkage: z = z0 (1 + a u / (1 + u/2)), u = 2 |j| / l, a = Soil::slip_sinkage. Measured
//     sinkages of a small wheel in sand under slip, skid and slip angles fall on one curve over u,
//     which is why shear, not slip, is the variable; the form of the curve is a fit to them
//     (VALIDATION.md). A wheel that is towed sinks least.
//   Trench: the soil between grousers goes backwards with them, a layer g h thick that is carried,
//     with s the slip by the shear radius, s/(1 - s) metres for each metre of travel. Continuity of
//     that flow digs a trench g h s/(1 - s) deep below z. It is cut, not pressed: it adds no
//     resistance.
//   Shear strength: H_max = b l_r c (1 + 2 g h/b) + W tan(phi) (1 + 0.64 g (h/b) atan(b/h))
//     (Bekker 1969 as in Li and Bingham's LTV paper; g is added here). Cohesion acts over the
//     contact l_r of the rim, which presses the soil; ahead of it only tips cut unpressed soil.
//   Driven rim: between grousers it slides on the soil with tan(delta) = f tan(phi) and adhesion
//     f^2 c, on the share 1 - g; adhesion is a smaller share than friction (Potyondy 1961).
//   Mobilised share: 1 - (1 - exp(-x))/x with x = 2 |j|/K (Janosi and Hanamoto 1961, integrated
//     along the contact as Wong did); K differs along and across the wheel. A smooth surface yields
//     after less travel than the soil itself, because a thinner layer is sheared (Uesugi and
//     Kishida 1986): K of the rim is f^2 K, f for the lower stress and f for the thinner layer, an
//     assumption that two measured wheels bear out. Rim and wedges act side by side, so their
//     stiffnesses add. Soil and wheel act in series and the softer one is taken: K is at least
//     H_max / tangential stiffness.
//   Braked wheel: a soil wedge sticks to it and moves along (Wong 1967), so soil shears on soil
//     whatever the rim is made of; smooth and grousered wheels measured under braking are alike.
//   Steady rolling: j = l/2 (r_s w - v)/(r_s w) + j0 v/(r_s w), l the contact of the soil body, at
//     a sinkage of z + g h. j0 = 2/3 z^2/l_r is what the curved rim shears without slip: r (theta -
//     sin theta), theta the entry angle, to 3 % at z = r/4; Wong and Reece's j(theta) (1967) at the
//     lowest point, where Bekker's pressure is highest. Its mean over the contact is 3/4 of that
//     and would let towed wheels skid less than they do (VALIDATION.md). It is why a wheel whose
//     rim does not slip resists less than a towed one. No measured wheel pulls there, while j0 on
//     soils of small K, which moves the soil ahead too, would make it: it counts up to the
//     displacement that mobilises a thrust of 0.95 R_c at the static sinkage.
//   Balance: pressure acts on the rim at an angle theta before the lowest point, tan(theta) =
//     R_c/W, so that shear carries load: W = N (cos theta + m sin theta), pull = N (m cos theta -
//     sin theta) with m = traction/W (Wong and Reece 1967, at one point instead of integrals). Pull
//     over load is tan(delta_m - theta) and stays finite whatever grousers add to m.
//   Ploughing: passive earth pressure (Rankine 1857) on the rim's face, of width b, for the part of
//     its travel (sideways included) that the wheel does not roll, as far as it exceeds the
//     compaction of the same face; and on its side, taken as the whole chord at full depth, while
//     it is pushed sideways. It adds to the shear strength. The two ends of the wedge widen the
//     face by half the wedge's length. The side wall rubs along the soil that it pushes
//     with tan(phi), as soil sticks to it: the soil stands, the wall moves as the wheel does at
//     half the depth.
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
  double load_n = 0;         // along the normal
  Vec3 normal_S;             // unit, out of the ground
  Vec3 heading_S;            // unit, rolling direction along the surface
  Vec3 hub_velocity_S_mps;   // velocity of the wheel's centre
  double rim_speed_mps = 0;  // shear radius (see WheelSoil) x spin
};

struct WheelContactForces {
  Vec3 traction_S_n = Vec3::Zero();   // shear force along the ground, applied `arm_m` below the hub
  Vec3 hub_force_S_n = Vec3::Zero();  // forces without torque: compaction, ploughing, flexing
  double arm_m = 0;                   // r_s
  double sinkage_m = 0;               // of the rim, with the trench
  double traction_limit_n = 0;        // of the contact as it is, driven or braked
  double soil_shear_n = 0;            // H_max, both under the force normal to the rim
};

// One kind of wheel on one kind of soil.
class WheelSoil {
 public:
  WheelSoil(const Soil& soil, const Wheel& wheel, double gravity_mps2);

  // Advances `state` by one step of `step_s` and returns the forces. A load of 0 resets the state.
  WheelContactForces forces(const WheelContactInput& input, double step_s,
                            WheelContactState& state) const;

  // Greatest shear force along the terrain, N, over a contact of this length: that which the soil
  // bears, and that which reaches it through a driven rim.
  double soil_shear_n(double load_n, double contact_length_m) const;
  double traction_limit_n(double load_n, double contact_length_m) const;
  // Passive earth pressure on a face of this width and depth, N.
  double ploughing_n(double width_m, double depth_m) const;
  const PressureSinkage& pressure() const { return pressure_; }
  // Radius r_s of the soil body that turns with the wheel.
  double shear_radius_m() const { return shear_radius_m_; }
  // Travel for each radian that the wheel turns under this load without net shear thrust, m.
  double rolling_radius_m(double load_n) const;

 private:
  struct Step;

  Step standing(double load_n) const;
  void set_contact(Step& step, double sinkage_m) const;
  void shear(Step& step, const Vec2& before_m, double step_s) const;
  void mobilise(Step& step) const;
  double slip_sinkage_m(const Step& step) const;
  Vec2 traction_n(const Step& step, const Vec2& before_m, double step_s) const;
  void press(Step& step) const;
  Vec2 resistance_n(const Step& step) const;
  double contact_length_m(double sinkage_m, const Step& step, double radius_m) const;
  double curvature(double sinkage_m, const Step& step) const;
  double rubbing(const Step& step) const;
  double trench_m(const Step& step) const;

  Soil soil_;
  Wheel wheel_;
  PressureSinkage pressure_;
  double unit_weight_npm3_ = 0;
  double shear_radius_m_ = 0, layer_m_ = 0;     // r_s, g h
  double rim_friction_ = 1, rim_adhesion_ = 1;  // of a driven wheel over those of the soil
  double rim_modulus_ = 1;                      // K of a driven wheel over that of the soil
  double shear_per_area_pa_ = 0, shear_per_load_ = 0, wall_friction_ = 0;
  double wedge_ = 0;  // tan(pi/4 + phi/2): root of K_p, and the wedge's length over its depth
};

// Reason why such a wheel cannot bear this load, because its carcass yields by more than half of
// its radius, else "".
std::string carcass_fault(const Wheel& wheel, double load_n);

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
