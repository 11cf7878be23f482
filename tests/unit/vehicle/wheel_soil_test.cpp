#include "vehicle/wheel_soil.h"

#include <gmock/gmock.h>

#include <cmath>

#include "test_rover.h"

namespace lsos {
namespace {

// Worked by hand for a wheel of the Apollo LRV (b 0.229 m, D 0.813 m, 283.5 N) on nominal lunar
// soil: sinkage 18.39 mm, compaction resistance 31.98 N, contact length 0.1227 m along the arc,
// smooth thrust limit 203.3 N.
const Wheel lrv_wheel{.radius_m = 0.4065, .width_m = 0.229};

TEST(WheelSoil, sinks_and_resists_as_worked_by_hand_for_the_lrv) {
  const double z_m = sinkage_m(test::soil(), lrv_wheel, 283.5);
  EXPECT_NEAR(z_m, 0.01839, 1e-5);
  EXPECT_NEAR(compaction_resistance_n(test::soil(), lrv_wheel, z_m), 31.98, 0.03);
  EXPECT_NEAR(contact_length_m(lrv_wheel, z_m), 0.1227, 0.002);
  EXPECT_NEAR(traction_limit_n(test::soil(), lrv_wheel, 283.5, 0.1227), 203.3, 0.1);
}

TEST(WheelSoil, compaction_resistance_is_the_work_of_the_pressure_law_a_metre) {
  // Second method: the integral of b p(z) dz by the midpoint rule.
  const Soil soil = test::soil();
  const double z_m = 0.02, b = lrv_wheel.width_m;
  double work = 0;
  constexpr int parts = 10000;
  for (int i = 0; i < parts; ++i) {
    const double z = (i + 0.5) * z_m / parts;
    work += b * (soil.k_c / b + soil.k_phi) * std::pow(z, soil.n) * z_m / parts;
  }
  EXPECT_NEAR(compaction_resistance_n(soil, lrv_wheel, z_m), work, 1e-6 * work);
}

WheelContactInput rolling(double slip) {
  WheelContactInput input;
  input.penetration_m = 0.003;
  input.normal_S = Vec3::UnitZ();
  input.heading_S = Vec3::UnitX();
  input.rolling_speed_mps = 1;
  input.hub_velocity_S_mps = {1 - slip, 0, 0};
  input.rim_velocity_S_mps = {-slip, 0, 0};
  return input;
}

Wheel stiff_wheel() {
  Wheel wheel = lrv_wheel;
  wheel.normal_stiffness_npm = 283.5 / 0.003;
  return wheel;
}

TEST(WheelSoil, steady_thrust_follows_janosi_and_hanamoto) {
  const Soil soil = test::soil();
  const Wheel wheel = stiff_wheel();
  for (const double slip : {0.02, 0.1, 0.3, 0.6, 0.9}) {
    WheelContactState state;
    WheelContactForces forces;
    for (int i = 0; i < 4000; ++i) forces = contact_forces(soil, wheel, rolling(slip), 1e-3, state);
    const double l_m = contact_length_m(wheel, forces.sinkage_m);
    // Wong (Theory of Ground Vehicles): thrust = limit x (1 - K/(s l) (1 - exp(-s l/K))).
    const double x = slip * l_m / soil.shear_modulus_m;
    const double limit_n = traction_limit_n(soil, wheel, forces.load_n, l_m);
    EXPECT_NEAR(forces.at_contact_S_n.x(), limit_n * (1 - (1 - std::exp(-x)) / x), 1e-3 * limit_n)
        << "slip " << slip;
  }
}

TEST(WheelSoil, traction_never_passes_the_strength_of_the_soil) {
  const Soil soil = test::soil();
  const Wheel wheel = stiff_wheel();
  WheelContactState state;
  WheelContactInput input = rolling(0);
  input.rim_velocity_S_mps = {3, -4, 0};
  for (int i = 0; i < 1000; ++i) {
    const WheelContactForces forces = contact_forces(soil, wheel, input, 1e-3, state);
    const double limit_n =
        traction_limit_n(soil, wheel, forces.load_n, contact_length_m(wheel, forces.sinkage_m));
    EXPECT_LE(forces.at_contact_S_n.head<2>().norm(), limit_n * (1 + 1e-12));
  }
}

TEST(WheelSoil, a_wheel_in_the_air_feels_nothing_and_forgets_the_soil) {
  WheelContactState state{Vec3(0.1, 0, 0)};
  WheelContactInput input = rolling(0.5);
  input.penetration_m = -0.01;
  const WheelContactForces forces = contact_forces(test::soil(), stiff_wheel(), input, 1e-3, state);
  EXPECT_EQ(forces.load_n, 0);
  EXPECT_EQ(forces.at_contact_S_n, Vec3::Zero());
  EXPECT_EQ(state.shear_S_m, Vec3::Zero());
}

TEST(SlipRatio, follows_the_definition_driving_and_braking) {
  EXPECT_DOUBLE_EQ(slip_ratio(0.8, 1), 0.2);
  EXPECT_DOUBLE_EQ(slip_ratio(-0.8, -1), 0.2);
  EXPECT_DOUBLE_EQ(slip_ratio(1, 0.8), -0.2);
  EXPECT_DOUBLE_EQ(slip_ratio(1, 0), -1);
  EXPECT_DOUBLE_EQ(slip_ratio(0, 1), 1);
  EXPECT_TRUE(std::isnan(slip_ratio(0.0005, -0.0005)));
}

}  // namespace
}  // namespace lsos
