#include "vehicle/drive_control.h"

#include <gtest/gtest.h>

#include <numbers>

#include "test_limbs.h"
#include "test_rovers.h"

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

// A limb whose hip yaws by 0.4 rad holds its wheel aside and turned.
TEST(WheelLayout, is_that_of_the_stance_in_which_limbs_stand) {
  VehicleConfig config = make_vehicle(test::rover_on_limbs(), "", 1.6);
  config.links[0].initial = 0.4;  // limb_1_yaw, 1 m from the middle at 30 degrees
  const WheelLayout turned = wheel_layout(config);
  const double azimuth_rad = std::numbers::pi / 6;
  const Vec2 hip_m(std::cos(azimuth_rad), std::sin(azimuth_rad));
  const Vec2 wheel_m = hip_m + Vec2(std::cos(azimuth_rad + 0.4), std::sin(azimuth_rad + 0.4));
  // The reference point is the middle of all wheels.
  const Vec2 middle_m = (wheel_m - 2 * hip_m) / 6;
  EXPECT_NEAR((turned.wheels[0].p_B_m - (wheel_m - middle_m)).norm(), 0, 1e-9);
  EXPECT_NEAR(turned.steerings[0].heading_rad, 0.4, 1e-9);
  EXPECT_NEAR(turned.steerings[1].heading_rad, 0, 1e-9);
  const WheelTargets targets = wheel_targets(turned, {1, 0, false}, straight);
  EXPECT_NEAR(targets.steering_angle_rad[0], -0.4, 1e-9);
  for (const double spin :
       wheel_targets(turned, {1, 0, false}, targets.steering_angle_rad).spin_radps) {
    EXPECT_NEAR(spin, 2, 1e-9);
  }
}

// A stuck wheel rolls as fast as the motion goes along it, and the others do not wait for it.
TEST(WheelTargets, of_a_stuck_steering_motor_go_along_its_angle) {
  std::vector<double> now = straight;
  now[0] = 1.2;
  std::vector<bool> are_stuck(6, false);
  are_stuck[0] = true;
  const WheelTargets targets = wheel_targets(layout, {2, 0, false}, now, are_stuck);
  EXPECT_EQ(targets.steering_angle_rad[0], 1.2);
  EXPECT_NEAR(targets.spin_radps[0], 4 * std::cos(1.2), 1e-12);
  EXPECT_DOUBLE_EQ(targets.spin_radps[11], 4);
  EXPECT_DOUBLE_EQ(wheel_targets(layout, {2, 0, false}, now).spin_radps[11], 0) << "turns it first";
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
  // Rim speeds are proportional to the distances from the centre.
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
  // In a turn on the spot a left wheel rolls backwards rather than turning right round.
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

TEST(WheelTargets, crab_with_all_wheels_alike) {
  std::vector<double> now = straight;
  for (int i = 0; i < 3; ++i) {
    now = wheel_targets(layout, {1, 0, false, 1}, now).steering_angle_rad;
  }
  const WheelTargets targets = wheel_targets(layout, {1, 0, false, 1}, now);
  for (const double angle : targets.steering_angle_rad) {
    EXPECT_NEAR(angle, std::numbers::pi / 4, 1e-12);
  }
  for (const double spin : targets.spin_radps) EXPECT_NEAR(spin, std::sqrt(2) / 0.5, 1e-12);
}

TEST(WheelTargets, turn_about_the_axle_of_wheels_that_cannot_steer) {
  // Front and rear steer, the middle wheels at x = 0.1 m are fixed: the centre of turning is at
  // (0.1, 2) for 2 m to the left, wherever the reference point is.
  VehicleConfig config = test::small_body();
  add_rocker_bogie(config, test::rocker_bogie());
  const WheelLayout rover = wheel_layout(config);
  EXPECT_DOUBLE_EQ(rover.turning_x_B_m, 0.1);
  std::vector<double> now(rover.steerings.size(), 0.0);
  for (int i = 0; i < 5; ++i) now = wheel_targets(rover, {0.2, 0.1, false}, now).steering_angle_rad;
  for (std::size_t i = 0; i < rover.steerings.size(); ++i) {
    const Vec2 to_centre = Vec2(0.1, 2) - rover.steerings[i].p_B_m;
    EXPECT_NEAR(Vec2(std::cos(now[i]), std::sin(now[i])).dot(to_centre), 0, 1e-12);
  }
}

TEST(WheelTargets, spread_the_speeds_of_a_skid_steered_rover) {
  VehicleConfig config = test::small_body();
  add_skid_steer(config, test::skid_steer());
  const WheelLayout rover = wheel_layout(config);
  const WheelTargets targets = wheel_targets(rover, {0.2, 0.1, false}, {});
  for (std::size_t i = 0; i < rover.wheels.size(); ++i) {
    // Wheels 0.3 m to either side count as 0.45 m.
    const double side = rover.wheels[i].p_B_m.y() > 0 ? -1 : 1;
    EXPECT_NEAR(targets.spin_radps[i] * 0.15, 0.2 + side * 0.1 * 0.45, 1e-12);
  }
}

}  // namespace
}  // namespace lsos
