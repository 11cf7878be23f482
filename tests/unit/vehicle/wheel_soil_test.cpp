#include "vehicle/wheel_soil.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "base/units.h"
#include "test_rover.h"
#include "vehicle/single_wheel.h"

namespace lsos {
namespace {

constexpr double g_moon_mps2 = 1.62;

// A wheel of the Apollo LRV (b 0.229 m, D 0.813 m, 283.5 N) on nominal lunar soil, with soil
// shearing on soil; reference values are computed manually.
constexpr double lrv_load_n = 283.5;
Wheel lrv_wheel() {
  return {.radius_m = 0.4065,
          .width_m = 0.229,
          .normal_stiffness_npm = 1e5,
          .interface_friction_ratio = 1};
}
WheelSoil lrv() { return {test::soil(), lrv_wheel(), g_moon_mps2}; }

TEST(WheelSoil, has_the_thrust_limit_worked_by_hand_for_the_lrv) {
  // Smooth thrust limit c A + W tan(phi) = 203.3 N; contact length along the arc 0.1227 m.
  EXPECT_NEAR(lrv().traction_limit_n(lrv_load_n, 0.1227), 203.3, 0.1);
  EXPECT_NEAR(lrv().pressure().contact_length_m(0.01839), 0.1227, 0.002);
}

WheelContactInput rolling(double slip) {
  WheelContactInput input;
  input.load_n = lrv_load_n;
  input.normal_S = Vec3::UnitZ();
  input.heading_S = Vec3::UnitX();
  input.rim_speed_mps = 1;
  input.hub_velocity_S_mps = {1 - slip, 0, 0};
  return input;
}

TEST(WheelSoil, steady_thrust_is_wong_and_reeces_integral_under_even_pressure) {
  // Second method: shear stress integrated over the contact angle, with the displacement
  //  j(theta) = R ((theta1 - theta) - (1 - s)(sin theta1 - sin theta)) of Wong and Reece (1967).
  const Soil soil = test::soil();
  const double R = lrv_wheel().radius_m;
  const double rolling_radius_m = lrv().rolling_radius_m(lrv_load_n);
  for (const double slip : {0.1, 0.3, 0.6, 0.9}) {
    const SingleWheelPoint point =
        single_wheel(lrv(), lrv_load_n, slip_by(rolling_radius_m, slip, R), 0);
    const double theta1 = std::acos(1 - point.sinkage_m / R);
    constexpr int parts = 2000;
    double share = 0;
    for (int i = 0; i < parts; ++i) {
      const double theta = theta1 * (i + 0.5) / parts;
      const double j = R * ((theta1 - theta) - (1 - slip) * (std::sin(theta1) - std::sin(theta)));
      share += (1 - std::exp(-j / soil.shear_modulus_x_m)) / parts;
    }
    EXPECT_NEAR(point.torque_n_m / R / point.traction_limit_n, share, 0.02) << "slip " << slip;
  }
}

TEST(WheelSoil, a_towed_wheel_is_pulled_with_its_compaction_resistance) {
  // With no torque at the axle, the drawbar pull is the work of the rut alone.
  const SingleWheelPoint towed = single_wheel(lrv(), lrv_load_n, 0, 0);
  const double ahead = lrv().rolling_radius_m(lrv_load_n) / lrv_wheel().radius_m;
  EXPECT_GT(ahead, 1);
  EXPECT_LT(ahead, 1.05);
  // 31.98 N is the manually computed resistance at the static sinkage.
  EXPECT_NEAR(-towed.drawbar_pull_n, 31.98, 1.5);
}

TEST(WheelSoil, sinkage_grows_with_slip_either_way_and_with_slip_angle) {
  double before_m = 0;
  for (const double slip : {0.0, 0.2, 0.5, 0.9}) {
    const double z_m = single_wheel(lrv(), lrv_load_n, slip, 0).sinkage_m;
    EXPECT_GT(z_m, before_m);
    before_m = z_m;
  }
  const double level_m = single_wheel(lrv(), lrv_load_n, 0, 0).sinkage_m;
  EXPECT_GT(single_wheel(lrv(), lrv_load_n, -0.5, 0).sinkage_m, level_m);
  EXPECT_GT(single_wheel(lrv(), lrv_load_n, 0, radians(30)).sinkage_m, level_m);
}

TEST(WheelSoil, mirrored_motion_has_mirrored_forces) {
  const SingleWheelPoint left = single_wheel(lrv(), lrv_load_n, 0.2, radians(20));
  const SingleWheelPoint right = single_wheel(lrv(), lrv_load_n, 0.2, radians(-20));
  EXPECT_LT(left.side_force_n, 0);  // pushed back to the right
  EXPECT_NEAR(left.side_force_n, -right.side_force_n, 1e-6);
  EXPECT_NEAR(left.drawbar_pull_n, right.drawbar_pull_n, 1e-6);
}

TEST(WheelSoil, a_stiffer_shear_modulus_across_weakens_only_the_side_force) {
  Soil soil = test::soil();
  soil.shear_modulus_y_m = 0.06;
  const WheelSoil stiff(soil, lrv_wheel(), g_moon_mps2);
  const auto side_n = [](const WheelSoil& w) {
    return -single_wheel(w, lrv_load_n, 0, radians(10)).side_force_n;
  };
  EXPECT_LT(side_n(stiff), 0.8 * side_n(lrv()));
  EXPECT_NEAR(single_wheel(stiff, lrv_load_n, 0.3, 0).drawbar_pull_n,
              single_wheel(lrv(), lrv_load_n, 0.3, 0).drawbar_pull_n, 1e-9);
}

// Measured driven wheels resist without slip, whatever they roll on.
TEST(WheelSoil, a_wheel_without_slip_does_not_pull) {
  for (const double modulus_m : {0.001, 0.005, 0.02}) {
    for (const double friction_deg : {25., 35., 45.}) {
      for (const double height_m : {0., 0.006, 0.015}) {
        for (const double load_n : {20., 200., 1000.}) {
          Soil soil = test::soil();
          soil.friction_rad = radians(friction_deg);
          soil.shear_modulus_x_m = soil.shear_modulus_y_m = modulus_m;
          Wheel wheel{.radius_m = 0.125, .width_m = 0.16, .normal_stiffness_npm = 3e5};
          wheel.grouser_height_m = height_m;
          wheel.grouser_count = height_m > 0 ? 24 : 0;
          const WheelSoil on_soil(soil, wheel, g_moon_mps2);
          EXPECT_LT(single_wheel(on_soil, load_n, 0, 0).drawbar_pull_n, 0)
              << modulus_m << ' ' << friction_deg << ' ' << height_m << ' ' << load_n;
        }
      }
    }
  }
}

// A wheel like that of Rashid (radius 0.1 m, grousers of 15 %) in a cohesive simulant: more than
// its own load is what no wheel was measured to pull.
TEST(WheelSoil, tall_grousers_in_cohesive_soil_pull_less_than_the_load) {
  Soil soil = test::soil();
  soil.k_c = 1370;
  soil.cohesion_pa = 2400;
  soil.friction_rad = radians(38);
  soil.density_kgpm3 = 1740;
  Wheel wheel{.radius_m = 0.1, .width_m = 0.08, .normal_stiffness_npm = 1e5};
  wheel.grouser_height_m = 0.015;
  wheel.grouser_count = 14;
  const WheelSoil on_soil(soil, wheel, 9.81);
  EXPECT_LT(single_wheel(on_soil, 24.5, 0.5, 0).drawbar_pull_n, 0.6 * 24.5);
}

// Continuity of the soil that goes backwards between grousers: g h s/(1 - s).
TEST(WheelSoil, grousers_dig_a_trench_by_the_soil_that_they_carry_away) {
  Wheel wheel{.radius_m = 0.1, .width_m = 0.1, .normal_stiffness_npm = 1e5};
  Soil soil = test::soil();
  soil.slip_sinkage = 0;
  // At this slip of the soil body.
  const auto sinkage_m = [&](double slip) {
    const WheelSoil on_soil(soil, wheel, 9.81);
    const double rolling_radius_m = on_soil.rolling_radius_m(30);
    const double counted = slip_by(rolling_radius_m, slip, on_soil.shear_radius_m());
    return single_wheel(on_soil, 30, counted, 0).sinkage_m;
  };
  wheel.grouser_height_m = 0.005;
  wheel.grouser_count = 24;
  const double layer_m = WheelSoil(soil, wheel, 9.81).shear_radius_m() - wheel.radius_m;
  EXPECT_GT(layer_m, 0.001);
  EXPECT_NEAR(sinkage_m(0.5) - sinkage_m(0), layer_m, 1e-6);
  EXPECT_NEAR(sinkage_m(0.75) - sinkage_m(0), 3 * layer_m, 1e-5);
}

// Green and Melzer (1971): the wire-mesh wheel of the LRV pulls nearly its most at a slip of 15 to
// 25 %, a rigid one about half.
TEST(WheelSoil, a_wheel_that_flattens_pulls_nearly_its_most_at_20_per_cent_slip) {
  Wheel mesh = lrv_wheel();
  mesh.carcass_stiffness_npm = 5500;
  const auto share = [](const WheelSoil& wheel) {
    return single_wheel(wheel, lrv_load_n, 0.2, 0).drawbar_pull_n /
           single_wheel(wheel, lrv_load_n, 0.9, 0).drawbar_pull_n;
  };
  EXPECT_GT(share({test::soil(), mesh, g_moon_mps2}), 0.8);
  EXPECT_LT(share(lrv()), 0.6);
}

// A wheel that rolls freely has no torque; its resistance is that of compaction and flexing.
TEST(WheelSoil, without_slip_there_is_no_shear_thrust) {
  Wheel wheel{.radius_m = 0.1, .width_m = 0.1, .normal_stiffness_npm = 1e5};
  for (const double height_m : {0.0, 0.008}) {
    wheel.grouser_height_m = height_m;
    wheel.grouser_count = height_m > 0 ? 20 : 0;
    for (const double load_n : {5.0, 30.0, 150.0}) {
      const WheelSoil on_soil(test::soil(), wheel, 9.81);
      const SingleWheelPoint point = single_wheel(on_soil, load_n, 0, 0);
      EXPECT_NEAR(point.torque_n_m / load_n / wheel.radius_m, 0, 1e-6) << load_n;
      EXPECT_LT(point.drawbar_pull_n, 0) << load_n;
      EXPECT_GT(on_soil.rolling_radius_m(load_n), on_soil.shear_radius_m()) << load_n;
    }
  }
}

TEST(SlipBy, another_radius_counts_what_rolls) {
  EXPECT_NEAR(slip_by(0.1, 0.2, 0.1), 0.2, 1e-12);
  EXPECT_NEAR(slip_by(0.1, -0.2, 0.1), -0.2, 1e-12);
  EXPECT_NEAR(slip_by(0.125, 0, 0.1), 0.2, 1e-12);  // rolls 1.25 m for each metre of travel
  EXPECT_NEAR(slip_by(0.125, -0.2, 0.1), 0, 1e-12);
  EXPECT_NEAR(slip_by(0.125, -1, 0.1), -1, 1e-12);
  EXPECT_NEAR(slip_by(0.125, 1, 0.1), 1, 1e-12);
}

TEST(WheelSoil, grousers_pull_more_the_higher_and_the_more_there_are) {
  double before_n = -1e9;
  for (const auto& [height_m, count] :
       {std::pair(0.0, 0), std::pair(0.005, 12), std::pair(0.005, 24), std::pair(0.015, 24)}) {
    Wheel wheel = lrv_wheel();
    wheel.interface_friction_ratio = 0.8;
    wheel.grouser_height_m = height_m;
    wheel.grouser_count = count;
    const WheelSoil grousered(test::soil(), wheel, g_moon_mps2);
    const double pull_n = single_wheel(grousered, lrv_load_n, 0.3, 0).drawbar_pull_n;
    EXPECT_GT(pull_n, before_n);
    before_n = pull_n;
  }
}

TEST(WheelSoil, a_single_grouser_changes_little) {
  Wheel wheel = lrv_wheel();
  wheel.interface_friction_ratio = 0.8;
  const auto pull_n = [&] {
    const WheelSoil on_soil(test::soil(), wheel, g_moon_mps2);
    return single_wheel(on_soil, lrv_load_n, 0.5, 0).drawbar_pull_n;
  };
  const double smooth_n = pull_n();
  wheel.grouser_height_m = 0.01;
  wheel.grouser_count = 1;
  EXPECT_NEAR(pull_n(), smooth_n, 0.01 * lrv_load_n);
}

TEST(WheelSoil, forces_go_smoothly_to_a_wheel_that_only_spins) {
  const SingleWheelPoint nearly = single_wheel(lrv(), lrv_load_n, 0.999, 0);
  const SingleWheelPoint wholly = single_wheel(lrv(), lrv_load_n, 1, 0);
  EXPECT_NEAR(nearly.drawbar_pull_n, wholly.drawbar_pull_n, 0.005 * lrv_load_n);
}

TEST(SoilFault, names_what_a_soil_cannot_carry) {
  EXPECT_EQ(soil_fault(test::soil(), lrv_wheel(), lrv_load_n, g_moon_mps2), "");
  EXPECT_THAT(soil_fault(test::soil(), lrv_wheel(), 1e6, g_moon_mps2),
              testing::HasSubstr("does not bear its wheels: with 1e+06 N each"));
  Soil water{.name = "Water", .density_kgpm3 = 1000};
  EXPECT_THAT(soil_fault(water, lrv_wheel(), 1, g_moon_mps2),
              testing::HasSubstr("neither cohesion nor friction"));
}

TEST(CarcassFault, names_what_flattens_a_wheel_too_far) {
  Wheel mesh = lrv_wheel();
  EXPECT_EQ(carcass_fault(mesh, 1e9), "");  // rigid
  mesh.carcass_stiffness_npm = 550;
  const double limit_n = 550 * mesh.radius_m / 2;
  EXPECT_EQ(carcass_fault(mesh, limit_n), "");
  EXPECT_THAT(carcass_fault(mesh, 1.1 * limit_n), testing::HasSubstr("more than half"));
}

TEST(WheelSoil, ploughing_is_rankines_passive_pressure_on_a_wide_face) {
  // Manual computation: Kp = tan^2(45 + 35/2 deg) = 3.690; gamma = 1520 x 1.62 = 2462.4 N/m3; 0.1 m
  // deep and 10 m wide 10 (2462.4 x 0.01 x 3.690 / 2 + 2 x 170 x 0.1 x 1.921) = 1107.4 N, and the
  // wedge's ends add 0.5 x 1.921 x 0.1 m to the width: 1 %.
  EXPECT_NEAR(lrv().ploughing_n(10, 0.1), 1107.4 * 1.0096, 1);
}

TEST(WheelSoil, a_locked_wheel_is_dragged_against_shear_compaction_and_ploughing) {
  const SingleWheelPoint locked = single_wheel(lrv(), lrv_load_n, -1, 0);
  const PressureSinkage pressure = lrv().pressure();
  // Shear and compaction at one tilted face add as tan(delta + theta), see the balance in
  // wheel_soil.h.
  const double compaction_n = pressure.compaction_resistance_n(locked.sinkage_m, lrv_load_n);
  const double contact_m = pressure.contact_length_m(locked.sinkage_m);
  const double m = 0.98 * lrv().soil_shear_n(lrv_load_n, contact_m) / lrv_load_n;
  const double t = compaction_n / lrv_load_n;
  const double ploughing_n = lrv().ploughing_n(0.229, locked.sinkage_m);
  const double expected_n =
      lrv_load_n * (m + t) / (1 - m * t) + std::max(0.0, ploughing_n - compaction_n);
  EXPECT_NEAR(-locked.drawbar_pull_n, expected_n, 0.03 * expected_n);
}

TEST(WheelSoil, on_rock_a_wheel_does_not_sink_and_pulls_by_friction) {
  Soil rock{.name = "Rock",
            .friction_rad = std::atan(0.7),
            .density_kgpm3 = 2900,
            .shear_modulus_x_m = 0.002,
            .shear_modulus_y_m = 0.002,
            .is_rigid = true};
  Wheel wheel = lrv_wheel();
  wheel.rolling_resistance = 0.02;
  const WheelSoil on_rock(rock, wheel, g_moon_mps2);
  const SingleWheelPoint spinning = single_wheel(on_rock, 100, 0.9, 0);
  EXPECT_EQ(spinning.sinkage_m, 0);
  EXPECT_NEAR(spinning.drawbar_pull_n, 100 * (0.7 - 0.02), 10);
  const SingleWheelPoint level = single_wheel(on_rock, 100, 0, 0);
  EXPECT_NEAR(level.drawbar_pull_n, -2, 1e-6);
}

TEST(WheelSoil, on_ground_that_it_hardly_marks_a_wheel_pulls_almost_as_on_rock) {
  Soil hardpan{.name = "Hardpan",
               .cohesion_pa = 20e3,
               .friction_rad = std::atan(0.7),
               .density_kgpm3 = 1800,
               .shear_modulus_x_m = 0.002,
               .shear_modulus_y_m = 0.002};
  Soil rock = hardpan;
  rock.is_rigid = true;
  rock.cohesion_pa = 0;
  const SingleWheelPoint on_hardpan =
      single_wheel({hardpan, lrv_wheel(), g_moon_mps2}, lrv_load_n, 0.2, 0);
  const SingleWheelPoint on_rock =
      single_wheel({rock, lrv_wheel(), g_moon_mps2}, lrv_load_n, 0.2, 0);
  EXPECT_LT(on_hardpan.sinkage_m, 0.001);
  EXPECT_GT(on_hardpan.drawbar_pull_n, 0.9 * on_rock.drawbar_pull_n);
}

TEST(WheelSoil, traction_never_passes_the_strength_of_the_soil) {
  const WheelSoil wheel_soil = lrv();
  WheelContactState state;
  WheelContactInput input = rolling(0);
  input.hub_velocity_S_mps = {4, -4, 0};
  for (int i = 0; i < 1000; ++i) {
    const WheelContactForces forces = wheel_soil.forces(input, 1e-3, state);
    EXPECT_LE(forces.traction_S_n.norm(), forces.traction_limit_n * (1 + 1e-12));
  }
}

TEST(WheelSoil, a_wheel_in_the_air_feels_nothing_and_forgets_the_soil) {
  WheelContactState state{Vec3(0.1, 0, 0), 0.001, 0.01};
  WheelContactInput input = rolling(0.5);
  input.load_n = 0;
  const WheelContactForces forces = lrv().forces(input, 1e-3, state);
  EXPECT_EQ(forces.traction_S_n, Vec3::Zero());
  EXPECT_EQ(forces.hub_force_S_n, Vec3::Zero());
  EXPECT_EQ(state.shear_S_m, Vec3::Zero());
  EXPECT_EQ(state.sinkage_m, 0);
}

TEST(NormalLoad, pushes_and_never_pulls) {
  const Wheel wheel{.normal_stiffness_npm = 1e4, .normal_damping_nspm = 100};
  EXPECT_EQ(normal_load_n(wheel, -0.01, 1), 0);
  EXPECT_DOUBLE_EQ(normal_load_n(wheel, 0.01, 0.1), 110);
  EXPECT_EQ(normal_load_n(wheel, 0.001, -1), 0);
}

TEST(SlipRatio, follows_the_definition_driving_and_braking) {
  EXPECT_DOUBLE_EQ(slip_ratio(0.8, 1), 0.2);
  EXPECT_DOUBLE_EQ(slip_ratio(-0.8, -1), 0.2);
  EXPECT_DOUBLE_EQ(slip_ratio(1, 0.8), -0.2);
  EXPECT_DOUBLE_EQ(slip_ratio(1, 0), -1);
  EXPECT_DOUBLE_EQ(slip_ratio(-1, 0), -1);
  EXPECT_DOUBLE_EQ(slip_ratio(0, 1), 1);
  EXPECT_TRUE(std::isnan(slip_ratio(0.0005, -0.0005)));
}

}  // namespace
}  // namespace lsos
