#include "vehicle/suspension/wishbone.h"

#include <gmock/gmock.h>

#include "test_rovers.h"
#include "test_site.h"
#include "vehicle/vehicle.h"
#include "wheel_loads.h"

namespace lsos {
namespace {

TEST(Wishbone, weighs_what_its_parts_weigh) {
  EXPECT_DOUBLE_EQ(test::rover(test::moon_g_mps2).mass_kg(), 3000 + 6 * (40 + 40 + 2 * 30));
}

TEST(Wishbone, module_that_does_not_steer_has_no_knuckle) {
  Wishbone suspension = test::suspension();
  suspension.modules[2].is_steered = suspension.modules[3].is_steered = false;
  VehicleConfig vehicle = test::wishbone_rover().vehicle;
  add_wishbone(vehicle, suspension, test::moon_g_mps2);
  EXPECT_DOUBLE_EQ(vehicle.mass_kg(), 3000 + 6 * (40 + 2 * 30) + 4 * 40);
  const WheelLayout layout = wheel_layout(vehicle);
  EXPECT_EQ(layout.steerings.size(), 4u);
  ASSERT_EQ(layout.wheels.size(), 12u);
  EXPECT_EQ(layout.wheels[4].steering, -1);
  EXPECT_EQ(layout.wheels[4].p_B_m, Vec2(0, 1.75));
}

TEST(Wishbone, carries_an_uneven_load_level) {
  VehicleConfig config = test::wishbone_rover().vehicle;
  config.p_BC_m = {0.4, -0.2, 1.2};
  add_wishbone(config, test::suspension(), test::moon_g_mps2);
  double preload_n = 0;
  Vec2 moment_n_m = Vec2::Zero();
  for (const LinkConfig& link : config.links) {
    if (!link.spring) continue;
    preload_n -= link.spring->preload;
    moment_n_m -= link.spring->preload * link.p_PJ_m.head<2>();
  }
  EXPECT_NEAR(preload_n, 3000 * test::moon_g_mps2, 1e-9);
  EXPECT_LT((moment_n_m - 3000 * test::moon_g_mps2 * Vec2(0.4, -0.2)).norm(), 1e-9);

  const auto ground = test::moon();
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  // The remaining tilt is due to unequal depths of the wheels in the ground, millimetres over
  // metres.
  EXPECT_NEAR(vehicle.report().pitch_rad, 0, 2e-3);
  EXPECT_NEAR(vehicle.report().roll_rad, 0, 2e-3);
  EXPECT_NEAR(test::sum(test::wheel_loads_n(vehicle)), config.mass_kg() * test::moon_g_mps2, 10);
}

TEST(Wishbone, modules_of_even_place_carry_even_loads) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  for (const auto& [name, load_n] : test::wheel_loads_n(vehicle)) {
    EXPECT_NEAR(load_n, 3840 * test::moon_g_mps2 / 12, 0.01 * 3840 * test::moon_g_mps2 / 12)
        << name;
  }
}

TEST(WishboneFaults, say_what_does_not_stand) {
  Wishbone suspension = test::suspension();
  EXPECT_TRUE(wishbone_faults(suspension).empty());
  suspension.modules.resize(2);
  suspension.modules[1].name = "front_left";
  suspension.wheel_offsets_m.clear();
  EXPECT_THAT(
      wishbone_faults(suspension),
      ::testing::ElementsAre("2 modules: at least 3 are needed to stand on",
                             "wheel_offsets_m is empty", "two modules are named 'front_left'"));
}

}  // namespace
}  // namespace lsos
