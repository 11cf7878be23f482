#include "base/segment.h"

#include <gtest/gtest.h>

#include <numbers>

namespace lsos::test {
namespace {

TEST(Segment, is_as_far_from_a_point_as_its_nearest_place) {
  const Vec2 a(0, 0), b(4, 0);
  EXPECT_DOUBLE_EQ(point_distance_m(a, b, Vec2(1, 3)), 3);
  EXPECT_DOUBLE_EQ(point_distance_m(a, b, Vec2(-3, 4)), 5);
  EXPECT_DOUBLE_EQ(point_distance_m(a, b, Vec2(7, -4)), 5);
  EXPECT_DOUBLE_EQ(point_distance_m(Vec3(0, 0, 0), Vec3(0, 0, 2), Vec3(3, 4, 1)), 5);
}

TEST(Segment, without_length_is_a_point) {
  const Vec2 a(1, 1);
  EXPECT_EQ(nearest_share(a, a, Vec2(5, 5)), 0);
  EXPECT_DOUBLE_EQ(point_distance_m(a, a, Vec2(4, 5)), 5);
}

TEST(Bend, is_positive_to_the_left_whatever_the_lengths) {
  using std::numbers::pi;
  EXPECT_DOUBLE_EQ(bend_rad({2, 0}, {0, 5}), pi / 2);
  EXPECT_DOUBLE_EQ(bend_rad({2, 0}, {1, -1}), -pi / 4);
  EXPECT_DOUBLE_EQ(bend_rad({0, 1}, {0, 3}), 0);
}

}  // namespace
}  // namespace lsos::test
