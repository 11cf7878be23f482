#include "route/cost/turn_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lsos {
namespace {

constexpr double pi = std::numbers::pi;

// A rover of 4 m by 2 m at the origin that heads along x.
Footprint turning_footprint() { return {Vec2::Zero(), Vec2::UnitX(), {2, 1}}; }

// A wall along x, `near_m` to the left.
std::vector<Footprint> wall(double near_m) { return {{{0, near_m + 1}, Vec2::UnitX(), {50, 1}}}; }

// The corner at 26.6 degrees and 2.24 m reaches the wall where 2.24 sin(26.6 deg + turn) equals the
// distance of the wall.
TEST(TurnRoom, ends_where_a_corner_reaches_the_wall) {
  const TurnRoom room = turn_room(turning_footprint(), Vec2::Zero(), 0, wall(1.5));
  const double expected_rad = std::asin(1.5 / std::hypot(2, 1)) - std::atan2(1, 2);
  EXPECT_NEAR(room.left_rad, expected_rad, pi / 90);
  EXPECT_LE(room.left_rad, expected_rad);
  // Its tail swings to the other side.
  EXPECT_NEAR(room.right_rad, room.left_rad, 1e-9);
  EXPECT_TRUE(room.allows(0.2));
  EXPECT_EQ(room.hindrance(pi / 2), 0u);
  EXPECT_EQ(room.hindrance(-pi / 2), 0u);
}

TEST(TurnRoom, is_all_round_where_nothing_stands_near) {
  EXPECT_TRUE(turn_room(turning_footprint(), Vec2::Zero(), 1, wall(2.3)).allows(1 - pi));
  EXPECT_TRUE(turn_room(turning_footprint(), Vec2::Zero(), 1, {}).allows(-2));
}

TEST(TurnRoom, counts_no_thing_that_it_touches_already) {
  EXPECT_TRUE(turn_room(turning_footprint(), Vec2::Zero(), 0, wall(0.9)).allows(pi / 2));
}

}  // namespace
}  // namespace lsos
