#include "route/free_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace lsos::test {
namespace {

Ring square(double x, double y, double half) {
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

double length_m(const Vec2& from, const std::vector<Vec2>& points) {
  double sum_m = 0;
  Vec2 at = from;
  for (const Vec2& point : points) {
    sum_m += (point - at).norm();
    at = point;
  }
  return sum_m;
}

// Looks at places a centimetre apart, not at the sums of the code.
double least_clearance_m(const Ring& ring, const Vec2& from, const std::vector<Vec2>& points) {
  double least_m = std::numeric_limits<double>::infinity();
  Vec2 at = from;
  for (const Vec2& point : points) {
    const int count = std::max(1, static_cast<int>((point - at).norm() / 0.01));
    for (int k = 0; k <= count; ++k) {
      const Vec2 p = at + (point - at) * k / count;
      least_m = std::min(least_m, contains(ring, p) ? -1 : (nearest_on_ring(ring, p) - p).norm());
    }
    at = point;
  }
  return least_m;
}

TEST(FreeArea, cuts_a_line_at_the_margin_of_a_hole) {
  const FreeArea area(square(0, 0, 10), {square(0, 0, 2)});
  const auto through = area.parts({-20, 0}, {20, 0}, 1);
  ASSERT_EQ(through.size(), 2u);
  EXPECT_NEAR(through[0].first, 0.25, 1e-12);
  EXPECT_NEAR(through[0].second, 17.0 / 40, 1e-12);
  EXPECT_NEAR(through[1].first, 23.0 / 40, 1e-12);
  EXPECT_NEAR(through[1].second, 0.75, 1e-12);
  // Half a metre above the hole the corners' circles alone reach the line: sqrt(1 - 0.25).
  const auto above = area.parts({-20, 2.5}, {20, 2.5}, 1);
  ASSERT_EQ(above.size(), 2u);
  EXPECT_NEAR(above[0].second * 40 - 20, -2 - std::sqrt(0.75), 1e-9);
  EXPECT_EQ(area.parts({-20, 3.1}, {20, 3.1}, 1).size(), 1u);
  EXPECT_EQ(area.parts({-20, 11}, {20, 11}, 1).size(), 0u);
}

TEST(FreeArea, goes_straight_where_nothing_is_in_the_way) {
  const FreeArea area(square(0, 0, 10), {square(0, 0, 2)});
  const auto path = area.path({-9, 8}, {9, 8}, 1);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->points_m.size(), 1u);
  EXPECT_EQ(path->points_m[0], Vec2(9, 8));
}

// Round a square, by two corners that stand off it: two slanting lines and a straight one.
TEST(FreeArea, goes_round_a_hole_by_the_shortest_path_that_keeps_the_margin) {
  const Ring hole = square(0, 0, 2);
  const FreeArea area(square(0, 0, 20), {hole});
  const Vec2 from(-10, 0.5), to(10, 0.5);
  const auto path = area.path(from, to, 1);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->margin_m, 1);
  EXPECT_NEAR(length_m(from, path->points_m), 2 * std::hypot(7, 2.5) + 6, 1e-9);
  EXPECT_NEAR(least_clearance_m(hole, from, path->points_m), 1, 0.01);
}

TEST(FreeArea, stays_within_an_outline_that_cuts_in) {
  const Ring outline{{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};
  const FreeArea area(outline, {});
  const Vec2 from(5, 30), to(25, 30);
  const auto path = area.path(from, to, 2);
  ASSERT_TRUE(path);
  // Below both corners of the bay, each passed two metres off at a right angle.
  EXPECT_NEAR(length_m(from, path->points_m), 2 * std::hypot(3, 22) + 14, 1e-9);
  Vec2 at = from;
  for (const Vec2& point : path->points_m) {
    for (int k = 1; k < 100; ++k) EXPECT_TRUE(contains(outline, at + (point - at) * k / 100.0));
    at = point;
  }
}

TEST(FreeArea, keeps_less_where_there_is_no_room_for_more) {
  const Ring hole = square(0, 0, 8);
  const FreeArea area(square(0, 0, 10), {hole});
  const Vec2 from(-9, 0), to(9, 0);
  const auto path = area.path(from, to, 4);
  ASSERT_TRUE(path);
  // Along the very outline.
  EXPECT_EQ(path->margin_m, 2);
  EXPECT_NEAR(least_clearance_m(hole, from, path->points_m), 1, 1e-6);  // as at both ends
}

TEST(FreeArea, is_left_where_that_is_nearest_by_what_stands_in_a_hole) {
  const FreeArea area(square(0, 0, 20), {square(0, 0, 5)});
  const auto path = area.path({4, 0}, {10, 0}, 1);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->points_m.size(), 2u);
  EXPECT_NEAR((path->points_m[0] - Vec2(6, 0)).norm(), 0, 1e-9);
}

TEST(FreeArea, has_paths_round_many_holes_that_enter_none) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-40, 40), turn(0, 2 * std::numbers::pi);
  std::vector<Ring> holes;
  for (int x = -30; x <= 30; x += 20) {
    for (int y = -30; y <= 30; y += 20) {
      Ring hole;
      const int corners = 3 + static_cast<int>(holes.size() % 5);
      const double from_rad = turn(random);
      for (int k = 0; k < corners; ++k) {
        const double angle_rad = from_rad + 2 * std::numbers::pi * k / corners;
        const double radius_m = k % 2 == 0 ? 6 : 3;
        hole.emplace_back(x + radius_m * std::cos(angle_rad), y + radius_m * std::sin(angle_rad));
      }
      holes.push_back(hole);
    }
  }
  const FreeArea area(square(0, 0, 45), holes);
  int found = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec2 from(place(random), place(random)), to(place(random), place(random));
    const bool is_in_hole = std::ranges::any_of(
        holes, [&](const Ring& hole) { return contains(hole, from) || contains(hole, to); });
    if (is_in_hole) continue;
    const auto path = area.path(from, to, 1);
    ASSERT_TRUE(path);
    ++found;
    EXPECT_EQ(path->points_m.back(), to);
    for (const Ring& hole : holes) {
      const double ends_m = std::min((nearest_on_ring(hole, from) - from).norm(),
                                     (nearest_on_ring(hole, to) - to).norm());
      EXPECT_GE(least_clearance_m(hole, from, path->points_m), std::min(1.0, ends_m) - 1e-5);
    }
  }
  EXPECT_GT(found, 30);
}

}  // namespace
}  // namespace lsos::test
