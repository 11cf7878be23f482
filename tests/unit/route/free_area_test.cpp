#include "route/map/free_area.h"

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

// Clearance of a path from places a centimetre apart, without the code under test.
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
  // Half a metre above the hole only the circles around its corners reach the line: sqrt(1 - 0.25).
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

// The path goes round a square by two corners that stand off it: two slanting lines and a straight
// one.
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
  // The path passes below both corners of the bay, two metres off each at a right angle.
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
  // The path follows the outline itself.
  EXPECT_EQ(path->margin_m, 2);
  EXPECT_NEAR(least_clearance_m(hole, from, path->points_m), 1, 1e-6);  // as at both ends
}

// Stops on a line that is cut at a hole lie on its very edge.
TEST(FreeArea, leads_from_edge_to_edge_of_a_hole_that_no_margin_is_kept_from) {
  const Ring hole = square(0.1, 0.3, 3);
  const FreeArea area(square(0, 0, 20), {hole});
  const auto parts = area.parts({-20, 1}, {20, 1}, 0);
  ASSERT_EQ(parts.size(), 2u);
  const Vec2 from(-20 + 40 * parts[0].second, 1), to(-20 + 40 * parts[1].first, 1);
  const auto path = area.path(from, to, 0);
  ASSERT_TRUE(path);
  EXPECT_NEAR(length_m(from, path->points_m), 6 + 2 * 2.3, 0.1);
  Vec2 at = from;
  for (const Vec2& point : path->points_m) {
    for (int k = 1; k < 100; ++k) {
      const Vec2 p = at + (point - at) * k / 100.0;
      EXPECT_TRUE(!contains(hole, p) || (nearest_on_ring(hole, p) - p).norm() < 1e-5);
    }
    at = point;
  }
  const auto along = area.path({3.1, -2}, {3.1, 3}, 0);
  ASSERT_TRUE(along);
  EXPECT_EQ(along->points_m.size(), 1u);
}

TEST(FreeArea, leads_through_a_neck_narrower_than_the_margin) {
  const FreeArea area({{0, 0},
                       {20, 0},
                       {20, 9.5},
                       {30, 9.5},
                       {30, 0},
                       {50, 0},
                       {50, 20},
                       {30, 20},
                       {30, 10.5},
                       {20, 10.5},
                       {20, 20},
                       {0, 20}},
                      {});
  const auto path = area.path({5, 2}, {45, 18}, 5);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->margin_m, 5);
}

// A coast of bays and headlands; the paths lead from one bay to others.
Ring coast(int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2 * std::numbers::pi * i / corners;
    const double rough_m = i % 2 == 0 ? 0.1 : -0.1;
    const double radius_m = 500 + 250 * std::sin(5 * angle_rad) + rough_m;
    ring.emplace_back(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
  }
  return ring;
}

Vec2 in_bay(int bay) {
  const double angle_rad = 2 * std::numbers::pi * (bay + 0.25) / 5;
  return 700 * Vec2(std::cos(angle_rad), std::sin(angle_rad));
}

TEST(FreeArea, has_paths_among_thousands_of_corners) {
  const Ring outline = coast(4000);
  const FreeArea area(outline, {});
  for (int bay = 1; bay < 5; ++bay) {
    const auto path = area.path(in_bay(0), in_bay(bay), 5);
    ASSERT_TRUE(path);
    ASSERT_FALSE(path->is_given_up);
    EXPECT_EQ(path->points_m.back(), in_bay(bay));
    EXPECT_GT(path->points_m.size(), 1u);
  }
}

TEST(FreeArea, says_when_corners_are_too_many_yet_goes_straight) {
  // A comb of bays 100 m long and 2 m wide, some of them 2 m shorter.
  Ring comb;
  for (int tooth = 0; tooth < 2500; ++tooth) {
    const double x_m = 4.0 * tooth, end_m = tooth % 2 == 0 ? 0 : 2;
    for (const Vec2& corner : {Vec2(x_m, 100), Vec2(x_m, end_m)}) comb.push_back(corner);
    for (const Vec2& corner : {Vec2(x_m + 2, end_m), Vec2(x_m + 2, 100)}) comb.push_back(corner);
  }
  for (const Vec2& corner : {Vec2(10000, 100), Vec2(10000, -50)}) comb.push_back(corner);
  comb.emplace_back(-2, -50);
  comb.emplace_back(-2, 100);
  const FreeArea area(comb, {});
  const auto path = area.path({3, 90}, {9003, 90}, 5);
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->is_given_up);
  const auto straight = area.path({3, 90}, {3, -40}, 5);
  ASSERT_TRUE(straight);
  EXPECT_FALSE(straight->is_given_up);
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
