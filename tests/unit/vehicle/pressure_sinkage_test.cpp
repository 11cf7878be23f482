#include "vehicle/pressure_sinkage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "base/units.h"
#include "test_rover.h"

namespace lsos {
namespace {

constexpr double g_mps2 = 1.62, radius_m = 0.4065, width_m = 0.229, load_n = 283.5;

Soil terzaghi() {
  Soil soil = test::soil();
  soil.k_c = soil.k_phi = 0;
  return soil;
}

TEST(BearingFactors, agree_with_terzaghis_table) {
  // Terzaghi (1943), printed to 0.1 up to N_q of 40 deg; beyond that his table was rounded more.
  for (const auto& [phi_deg, N_c, N_q] :
       {std::tuple(0.0, 5.7, 1.0), std::tuple(10.0, 9.6, 2.7), std::tuple(20.0, 17.7, 7.4),
        std::tuple(30.0, 37.2, 22.5), std::tuple(35.0, 57.8, 41.4),
        std::tuple(45.0, 172.3, 173.3)}) {
    const BearingFactors f = bearing_factors(radians(phi_deg));
    EXPECT_NEAR(f.N_c, N_c, 0.06) << phi_deg;
    EXPECT_NEAR(f.N_q, N_q, 0.06) << phi_deg;
  }
  EXPECT_NEAR(bearing_factors(radians(35)).N_gamma, 47.28, 0.01);  // Coduto's formula, manually
}

TEST(PressureSinkage, bekkers_law_as_worked_by_hand_for_the_lrv) {
  const PressureSinkage law(test::soil(), radius_m, width_m, g_mps2);
  const double z_m = law.static_sinkage_m(load_n);
  EXPECT_NEAR(z_m, 0.01839, 1e-5);
  EXPECT_NEAR(law.rut_work_n(z_m), 31.98, 0.03);
  EXPECT_NEAR(law.compaction_resistance_n(z_m, load_n), 31.98, 0.03);
}

TEST(PressureSinkage, terzaghis_law_as_worked_by_hand_for_the_lrv) {
  const PressureSinkage law(terzaghi(), radius_m, width_m, g_mps2);
  const double z_m = law.static_sinkage_m(load_n);
  EXPECT_NEAR(z_m, 0.0080, 1e-4);
  // Four wheels: 27 Wh/km.
  EXPECT_NEAR(4 * law.rut_work_n(z_m) / 3.6, 27, 0.7);
}

TEST(PressureSinkage, compaction_resistance_is_the_work_of_the_pressure_law_a_metre) {
  // Second method: the integral of b p(z) dz by the midpoint rule.
  const Soil soil = test::soil();
  const PressureSinkage law(soil, radius_m, width_m, g_mps2);
  const double z_m = law.static_sinkage_m(load_n);
  double work = 0;
  constexpr int parts = 10000;
  for (int i = 0; i < parts; ++i) {
    const double z = (i + 0.5) * z_m / parts;
    work += width_m * (soil.k_c / width_m + soil.k_phi) * std::pow(z, soil.n) * z_m / parts;
  }
  EXPECT_NEAR(law.compaction_resistance_n(z_m, load_n), work, 1e-6 * work);
}

TEST(PressureSinkage, both_laws_carry_the_load_at_their_static_sinkage) {
  for (const Soil& soil : {test::soil(), terzaghi()}) {
    const PressureSinkage law(soil, radius_m, width_m, g_mps2);
    for (const double load : {1.0, 30.0, 283.5, 2000.0}) {
      EXPECT_NEAR(law.load_n(law.static_sinkage_m(load)), load, 1e-5 * load);
    }
    EXPECT_EQ(law.static_sinkage_m(0), 0);
    EXPECT_LE(law.static_sinkage_m(1e9), radius_m);
  }
}

TEST(PressureSinkage, cohesion_alone_and_friction_alone_carry_a_wheel) {
  Soil clay = terzaghi(), sand = terzaghi();
  clay.friction_rad = 0;
  clay.cohesion_pa = 5000;
  sand.cohesion_pa = 0;
  for (const Soil& soil : {clay, sand}) {
    const PressureSinkage law(soil, radius_m, width_m, g_mps2);
    const double z_m = law.static_sinkage_m(load_n);
    EXPECT_GT(z_m, 0);
    EXPECT_NEAR(law.load_n(z_m), load_n, 1e-4 * load_n);
  }
}

// A wheel that yields sinks less, the more so the softer it is; the rigid one is its limit.
TEST(PressureSinkage, a_wheel_that_yields_lies_longer_and_sinks_less) {
  for (const auto& [soil, weight_n] :
       {std::pair(test::soil(), 283.5), std::pair(terzaghi(), 4000.)}) {
    const PressureSinkage law(soil, radius_m, width_m, g_mps2);
    double before_m = law.static_sinkage_m(weight_n), resisted_n = weight_n;
    EXPECT_NEAR(law.static_sinkage_m(weight_n, 1e-9), before_m, 1e-3 * before_m);
    for (const double yields_m : {0.005, 0.02, 0.05}) {
      const double z_m = law.static_sinkage_m(weight_n, yields_m);
      EXPECT_NEAR(law.load_n(z_m, yields_m), weight_n, 1e-5 * weight_n);
      EXPECT_LT(z_m, before_m);
      EXPECT_GT(law.contact_length_m(z_m, yields_m), law.contact_length_m(before_m));
      const double resistance_n = law.compaction_resistance_n(z_m, weight_n, yields_m);
      EXPECT_LT(resistance_n, resisted_n);
      before_m = z_m;
      resisted_n = resistance_n;
    }
  }
}

TEST(PressureSinkage, cohesion_bears_a_soft_wheel_without_sinkage) {
  const PressureSinkage law(terzaghi(), radius_m, width_m, g_mps2);
  EXPECT_EQ(law.static_sinkage_m(100, 0.05), 0);
  EXPECT_EQ(law.compaction_resistance_n(0, 100, 0.05), 0);
}

// Second method: pressure over the wheel's outline, level in the middle and a circle ahead of it,
// by the midpoint rule; the formula takes the circle for a parabola, as Bekker does: 3 % at 0.05 m.
TEST(PressureSinkage, of_a_wheel_that_yields_is_the_integral_over_its_outline) {
  const Soil soil = test::soil();
  const PressureSinkage law(soil, radius_m, width_m, g_mps2);
  for (const double yields_m : {0.01, 0.05}) {
    const double z_m = law.static_sinkage_m(load_n, yields_m);
    const double level_m = std::sqrt(yields_m * (2 * radius_m - yields_m));
    const double entry_m = std::sqrt((z_m + yields_m) * (2 * radius_m - z_m - yields_m));
    const double k = soil.k_c + width_m * soil.k_phi;
    double carried_n = k * std::pow(z_m, soil.n) * 2 * level_m;
    constexpr int parts = 10000;
    for (int i = 0; i < parts; ++i) {
      const double x = level_m + (i + 0.5) * (entry_m - level_m) / parts;
      const double up_m = radius_m - yields_m - std::sqrt(radius_m * radius_m - x * x);
      carried_n += k * std::pow(std::max(0.0, z_m - up_m), soil.n) * (entry_m - level_m) / parts;
    }
    EXPECT_NEAR(carried_n, load_n, 0.035 * load_n);
  }
}

}  // namespace
}  // namespace lsos
