#include "mission/routes/drawn_leg.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lsos {
namespace {

// A circle of radius 3 m to the left of a rover that heads along x has its centre at (0, 3).
TEST(DrawnLeg, a_place_within_the_turning_circle_is_missed_by_its_depth) {
  const Vec2 ahead = Vec2::UnitX();
  EXPECT_NEAR(miss_distance_m(ahead, {0, 3}, 3), 3, 1e-12);
  EXPECT_NEAR(miss_distance_m(ahead, {0, -2}, 3), 2, 1e-12);
  EXPECT_NEAR(miss_distance_m(ahead, {0, 6}, 3), 0, 1e-12);
  EXPECT_NEAR(miss_distance_m(ahead, {3, 3}, 3), 0, 1e-12);
  EXPECT_LE(miss_distance_m(ahead, {10, 0}, 3), 0);
  EXPECT_LE(miss_distance_m(ahead, {-1, 7}, 3), 0);
  // The same turned by 90 degrees.
  EXPECT_NEAR(miss_distance_m(Vec2::UnitY(), {2, 0}, 3), 2, 1e-12);
}

}  // namespace
}  // namespace lsos
