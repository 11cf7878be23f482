#include "base/polygon.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lsos::test {
namespace {

// An L of three unit squares, with one corner cut in.
const Ring l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(Polygon, holds_what_lies_in_it_and_not_in_what_is_cut_out_of_it) {
  EXPECT_TRUE(contains(l_shape, {0.5, 0.5}));
  EXPECT_TRUE(contains(l_shape, {1.5, 0.5}));
  EXPECT_FALSE(contains(l_shape, {1.5, 1.5}));
  EXPECT_FALSE(contains(l_shape, {-0.1, 0.5}));
}

TEST(Polygon, has_three_units_of_area_whichever_way_it_goes_round) {
  EXPECT_DOUBLE_EQ(doubled_area_m2(l_shape), 6);
  EXPECT_DOUBLE_EQ(doubled_area_m2(Ring(l_shape.rbegin(), l_shape.rend())), -6);
}

TEST(Polygon, is_as_far_as_its_nearest_side) {
  EXPECT_NEAR((nearest_on_ring(l_shape, {2, 2}) - Vec2(2, 2)).norm(), 1, 1e-12);
  EXPECT_NEAR((nearest_on_ring(l_shape, {3, 3}) - Vec2(3, 3)).norm(), std::sqrt(5), 1e-12);
}

TEST(Segments, that_cross_are_at_no_distance) {
  EXPECT_EQ(segment_distance_m({0, 0}, {1, 1}, {0, 1}, {1, 0}), 0);
  EXPECT_EQ(segment_distance_m({0, 0}, {1, 0}, {1, 0}, {2, 5}), 0);
}

TEST(Segments, are_as_far_as_their_nearest_places) {
  EXPECT_NEAR(segment_distance_m({0, 0}, {1, 0}, {0, 2}, {1, 2}), 2, 1e-12);
  EXPECT_NEAR(segment_distance_m({0, 0}, {1, 0}, {4, 4}, {4, 9}), 5, 1e-12);
}

TEST(Rings, touch_at_a_corner_and_a_side_alike) {
  const Ring beside{{2, 0}, {3, 0}, {3, 1}, {2, 1}}, apart{{2.1, 0}, {3, 0}, {3, 1}, {2.1, 1}};
  const Ring within{{0.2, 0.2}, {0.4, 0.2}, {0.3, 0.4}};
  EXPECT_TRUE(do_touch(l_shape, beside));
  EXPECT_FALSE(do_touch(l_shape, apart));
  EXPECT_FALSE(do_touch(l_shape, within));
}

TEST(Rings, that_cross_themselves_are_found) {
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(crosses_itself(l_shape));
  EXPECT_FALSE(touches_itself(l_shape));
  // The fourth vertex lies on the first side.
  const Ring pinched{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}};
  EXPECT_FALSE(crosses_itself(pinched));
  EXPECT_TRUE(touches_itself(pinched));
}

}  // namespace
}  // namespace lsos::test
