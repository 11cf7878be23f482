#include "driving/slope_speed.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

constexpr double speed_mps = 2.5, acceleration_mps2 = 0.5, moon_mps2 = 1.62;

double slope_limit_mps(double pitch_rad) {
  return slope_speed_mps({pitch_rad, 0}, speed_mps, acceleration_mps2, moon_mps2);
}

TEST(Downhill, leaves_the_speed_alone_uphill_on_the_level_and_on_gentle_slopes) {
  for (const double pitch_rad : {0.4, 0.0, -0.1}) {
    EXPECT_EQ(braking_mps2({pitch_rad, 0}, acceleration_mps2, moon_mps2), acceleration_mps2);
    EXPECT_EQ(slope_limit_mps(pitch_rad), speed_mps);
  }
}

TEST(Downhill, stops_on_as_short_a_way_as_on_the_level) {
  const double level_m = speed_mps * speed_mps / (2 * acceleration_mps2);
  for (const double pitch_rad : {-0.2, -0.3, -0.36}) {
    const double slowing_mps2 = braking_mps2({pitch_rad, 0}, acceleration_mps2, moon_mps2);
    EXPECT_LT(slowing_mps2, acceleration_mps2);
    EXPECT_NEAR(slope_limit_mps(pitch_rad) * slope_limit_mps(pitch_rad) / (2 * slowing_mps2),
                level_m, 1e-9);
  }
}

// At the slope whose tangent is the friction coefficient, friction only just holds a block.
TEST(Downhill, creeps_where_nothing_is_left_to_brake_with) {
  const double steepest_rad = -std::atan(braking_friction);
  EXPECT_EQ(braking_mps2({steepest_rad, 0}, acceleration_mps2, moon_mps2),
            braking_share_min * acceleration_mps2);
  EXPECT_EQ(slope_limit_mps(2 * steepest_rad), slope_limit_mps(steepest_rad));
  EXPECT_GT(slope_limit_mps(2 * steepest_rad), 0.4 * speed_mps);
}

// A block slides down the steepest slope whatever its heading: where friction only just holds it,
// nothing is left for braking in any direction that does not lead up.
TEST(Downhill, has_its_grip_for_the_slope_across_too) {
  const double slope_rad = std::atan(braking_friction);
  for (const double aside_rad : {0.3, 0.8, 1.2, -0.8}) {
    const Incline ground{std::asin(-std::sin(slope_rad) * std::cos(aside_rad)),
                         std::asin(std::sin(slope_rad) * std::sin(aside_rad))};
    EXPECT_NEAR(braking_mps2(ground, acceleration_mps2, moon_mps2),
                braking_share_min * acceleration_mps2, 0.02)
        << aside_rad;
  }
  const Incline across{-0.15, 0.3};
  EXPECT_LT(slope_speed_mps(across, speed_mps, acceleration_mps2, moon_mps2),
            slope_limit_mps(-0.15));
}

}  // namespace
}  // namespace lsos
