#include "vehicle/footprint.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "test_rover.h"

namespace lsos {
namespace {

const Footprint rest = footprint_at_rest(test::rover(1.6));

TEST(Footprint, goes_round_chassis_and_wheels) {
  // Wheels of radius 0.5 m at x = 2 m; outer wheels at 1.75 m, 0.3 m wide.
  EXPECT_NEAR(rest.half_m.x(), 2.5, 1e-12);
  EXPECT_NEAR(rest.half_m.y(), 1.9, 1e-12);
  EXPECT_NEAR(rest.center_S_m.norm(), 0, 1e-12);
}

Footprint at(double x_m, double y_m, double yaw_deg, const Vec2& reach_m = Vec2::Zero()) {
  return moved(rest, {x_m, y_m}, radians(yaw_deg), reach_m);
}

TEST(Footprint, overlaps_by_its_corners_not_by_a_circle) {
  EXPECT_TRUE(overlap(at(0, 0, 0), at(4.9, 0, 0)));
  EXPECT_FALSE(overlap(at(0, 0, 0), at(5.1, 0, 0)));
  EXPECT_FALSE(overlap(at(0, 0, 0), at(0, 3.9, 0)));
  EXPECT_FALSE(overlap(at(0, 0, 0), at(4.5, 0, 90)));
  EXPECT_TRUE(overlap(at(0, 0, 0), at(4.3, 0, 90)));
  // A corner at 45 degrees reaches (2.5 + 1.9) / sqrt(2) = 3.11 m along x.
  EXPECT_TRUE(overlap(at(0, 0, 0), at(5.6, 0, 45)));
  EXPECT_FALSE(overlap(at(0, 0, 0), at(5.62, 0, 45)));
}

TEST(Footprint, gap_is_the_distance_of_parallel_sides) {
  EXPECT_NEAR(gap_m(at(0, 0, 0), at(7, 1, 0)), 2, 1e-12);
  EXPECT_NEAR(gap_m(at(0, 0, 0), at(4, 0, 0)), -1, 1e-12);
}

TEST(Footprint, reaches_as_far_as_the_rover_needs_to_stop) {
  EXPECT_FALSE(overlap(at(0, 0, 0), at(9, 0, 0)));
  EXPECT_TRUE(overlap(at(0, 0, 0, {4.1, 0}), at(9, 0, 0)));
  EXPECT_FALSE(overlap(at(0, 0, 0, {-4.1, 0}), at(9, 0, 0)));
  EXPECT_TRUE(overlap(at(0, 0, 0, {0, 3}), at(0, 6.7, 0)));
}

}  // namespace
}  // namespace lsos
