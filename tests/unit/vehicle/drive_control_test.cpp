#include "vehicle/drive_control.h"

#include <gtest/gtest.h>

#include <numbers>

#include "test_rover.h"

namespace lsos {
namespace {

const WheelLayout layout = wheel_layout(test::rover(1.6));
const std::vector<double> straight(6, 0.0);

TEST(WheelLayout, finds_modules_and_wheels_where_they_are) {
  ASSERT_EQ(layout.steerings.size(), 6u);
  ASSERT_EQ(layout.wheels.size(), 12u);
  EXPECT_EQ(layout.steerings[0].p_B_m, Vec2(2, 1.5));
  EXPECT_EQ(layout.wheels[0].p_B_m, Vec2(2, 1.75));
  EXPECT_EQ(layout.wheels[0].steering, 0);
  EXPECT_DOUBLE_EQ(layout.wheels[1].offset_m, -0.25);
}

TEST(WheelTargets, roll_all_wheels_alike_straight_ahead) {
  const WheelTargets targets = wheel_targets(layout, {2, 0, false}, straight);
  for (const double angle : targets.steering_angle_rad) EXPECT_DOUBLE_EQ(angle, 0);
  for (const double spin : targets.spin_radps) EXPECT_DOUBLE_EQ(spin, 4);
}

TEST(WheelTargets, point_every_axle_at_one_centre_of_turning) {
  // Radius 10 m to the left: axles meet at (0, 10).
  std::vector<double> now = straight;
  for (int i = 0; i < 3; ++i) now = wheel_targets(layout, {1, 0.1, false}, now).steering_angle_rad;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec2 to_centre = Vec2(0, 10) - layout.steerings[i].p_B_m;
    const Vec2 heading(std::cos(now[i]), std::sin(now[i]));
    EXPECT_NEAR(heading.dot(to_centre), 0, 1e-12);
  }
  // Speeds are as distances from the centre.
  const WheelTargets targets = wheel_targets(layout, {1, 0.1, false}, now);
  for (std::size_t i = 0; i < 12; ++i) {
    const auto& wheel = layout.wheels[i];
    const double angle = now[static_cast<std::size_t>(wheel.steering)];
    const Vec2 at = layout.steerings[static_cast<std::size_t>(wheel.steering)].p_B_m +
                    wheel.offset_m * Vec2(-std::sin(angle), std::cos(angle));
    EXPECT_NEAR(std::abs(targets.spin_radps[i]) * 0.5, 0.1 * (Vec2(0, 10) - at).norm(), 1e-9);
  }
}

TEST(WheelTargets, take_the_nearer_of_two_directions) {
  // Turning on the spot: a left wheel rolls back rather than turn right round.
  const WheelTargets targets = wheel_targets(layout, {0, 0.1, false}, straight);
  for (const double angle : targets.steering_angle_rad) {
    EXPECT_LE(std::abs(angle), std::numbers::pi / 2 + 1e-12);
  }
}

TEST(WheelTargets, wait_for_the_steering_before_they_turn) {
  const WheelTargets targets = wheel_targets(layout, {0, 0.1, false}, straight);
  for (const double spin : targets.spin_radps) EXPECT_EQ(spin, 0);
}

TEST(WheelTargets, keep_their_angles_when_standing_still) {
  std::vector<double> now(6, 0.3);
  EXPECT_EQ(wheel_targets(layout, {0, 0, false}, now).steering_angle_rad, now);
}

}  // namespace
}  // namespace lsos
