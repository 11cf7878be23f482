#include "vehicle/drive_power.h"

#include <gtest/gtest.h>

#include "test_rover.h"
#include "vehicle/vehicle.h"

namespace lsos {
namespace {

const DriveMotor lossy{
    .efficiency = 0.8, .winding_loss_w_pn2m2 = 0.05, .friction_n_m = 2, .idle_w = 5};

TEST(DrivePower, adds_the_losses_of_gears_windings_friction_and_controller) {
  // 20 N m at 3 rad/s: 60 W of work.
  EXPECT_NEAR(drive_power_w(lossy, 20, 3), 60 / 0.8 + 0.05 * 400 + 2 * 3 + 5, 1e-12);
  EXPECT_NEAR(drive_power_w(lossy, -20, -3), drive_power_w(lossy, 20, 3), 1e-12);
  // Holding without turning takes current, standing idle takes the controller's power.
  EXPECT_NEAR(drive_power_w(lossy, 20, 0), 0.05 * 400 + 5, 1e-12);
  EXPECT_NEAR(drive_power_w(lossy, 0, 0), 5, 1e-12);
}

TEST(DrivePower, of_a_motor_that_brakes_covers_its_own_losses_and_feeds_nothing_back) {
  // Gears pass 48 of 60 W on; windings and friction lose 26 W of it.
  EXPECT_NEAR(drive_power_w(lossy, -20, 3), 5, 1e-12);
  // At 1 rad/s 16 W come through and 22 W are lost.
  EXPECT_NEAR(drive_power_w(lossy, -20, 1), 0.05 * 400 + 2 - 0.8 * 20 + 5, 1e-12);
  EXPECT_EQ(drive_power_w({.efficiency = 0.5}, -20, 3), 0);
}

// Winding loss and idle power are spent by the second: a slow rover spends more of them on a metre.
TEST(DrivePower, for_a_metre_falls_with_speed) {
  const auto ground = test::moon();
  constexpr double g = 1.6242;
  const auto jpm = [&](double speed_mps) {
    VehicleConfig config = test::rover(g);
    for (LinkConfig& link : config.links) {
      if (!link.drive) continue;
      link.drive->winding_loss_w_pn2m2 = 0.005;
      link.drive->friction_n_m = 5;
      link.drive->idle_w = 10;
    }
    Vehicle vehicle(config, *ground);
    vehicle.place({0.1, 0.2, 0}, 0);
    vehicle.command({speed_mps, 0, false});
    for (int i = 0; i < 300; ++i) vehicle.advance(exchange_period);
    const double before_j = vehicle.drive_j(), before_m = vehicle.distance_m();
    for (int i = 0; i < 100; ++i) vehicle.advance(exchange_period);
    return (vehicle.drive_j() - before_j) / (vehicle.distance_m() - before_m);
  };
  const double slow_jpm = jpm(1), fast_jpm = jpm(2.5);
  // 12 controllers of 10 W: 120 J/m at 1 m/s, 48 at 2.5 m/s; windings add to the difference.
  EXPECT_GT(slow_jpm - fast_jpm, 72);
  EXPECT_LT(slow_jpm - fast_jpm, 120);
}

}  // namespace
}  // namespace lsos
