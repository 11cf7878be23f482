// Stances of a rover on ground of a known slope.
#include "route/cost/stance.h"

#include <gtest/gtest.h>

#include "test_rover.h"

namespace lsos::test {
namespace {

constexpr double slope_rad = 12 * deg;

// Ground that falls to the south.
struct Slope {
  SiteFrame site{*find_body("Moon"), geodetic_from_degrees(30, 10)};
  Ground ground{[] {
                  TerrainSpec spec;
                  spec.layers = {PlaneSurface{0, slope_rad, std::numbers::pi}};
                  return spec;
                }(),
                site, 0};
  GroundMap map{ground, MapFrame(site, {0, 0, 0}), {-20, -20}, {20, 20}, 0.5};
};

TEST(Stance, on_a_slope_is_the_slope_by_its_heading) {
  Slope slope;
  const StanceFinder finder(simple_rover());
  for (const double yaw_deg : {0.0, 30.0, 90.0, 200.0, 270.0}) {
    const Vec2 ahead(std::cos(yaw_deg * deg), std::sin(yaw_deg * deg));
    const Stance stance = finder.at(slope.map, {3, -2}, ahead);
    ASSERT_TRUE(stance.is_on_ground);
    EXPECT_NEAR(std::tan(stance.pitch_rad), std::tan(slope_rad) * ahead.y(), 1e-3) << yaw_deg;
    EXPECT_NEAR(std::tan(stance.bank_rad), std::tan(slope_rad) * ahead.x(), 1e-3) << yaw_deg;
    EXPECT_NEAR(stance.slope_rad, slope_rad, 1e-3);
    EXPECT_NEAR(stance.unevenness_m, 0, 1e-3);
    EXPECT_NEAR(stance.clearance_m, 0.4, 1e-3);
  }
}

// Compares with all nodes of the map. Forms stand between the corners of the chassis, the only
// points of it that are always sampled.
TEST(Stance, has_the_least_clearance_of_all_nodes_under_the_chassis) {
  const Site site({{0.5, 0.3, 0.7, 0.05, 0.25}, {-0.6, -0.5, 0.5, 0.02, 0.2}});
  DriveCost cost = simple_rover();
  cost.underside_B_m.clear();
  const Vec2 half_m(1.1, 0.7);
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      cost.underside_B_m.push_back({x * half_m.x(), y * half_m.y(), 0.4});
    }
  }
  cost.limits.clearance_min_m = 0.39;  // too near to the limit: all nodes are checked
  const StanceFinder finder(cost);
  GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-10, -10}, {10, 10},
                0.2);
  int lower = 0;
  for (const double yaw_deg : {0.0, 30.0, 90.0, 90.0 + 1e-7, 133.0, 200.0, 270.0}) {
    for (const Vec2& at_m : {Vec2(0.03, 0.01), Vec2(0.41, -0.13), Vec2(-0.27, 0.33)}) {
      const Vec2 ahead(std::cos(yaw_deg * deg), std::sin(yaw_deg * deg)),
          left(-ahead.y(), ahead.x());
      const Stance stance = finder.at(map, at_m, ahead);
      ASSERT_TRUE(stance.is_on_ground);
      // Plane under the wheels, computed independently.
      Eigen::Matrix<double, 4, 3> places;
      Eigen::Vector4d heights_m;
      for (Eigen::Index k = 0; k < 4; ++k) {
        const Vec2 wheel_B_m = cost.wheels_B_m[static_cast<std::size_t>(k)];
        places.row(k) << 1, wheel_B_m.x(), wheel_B_m.y();
        heights_m[k] = map.height_m(at_m + wheel_B_m.x() * ahead + wheel_B_m.y() * left);
      }
      const Vec3 plane = places.colPivHouseholderQr().solve(heights_m);
      const auto over_m = [&](const Vec2& p_B_m, double ground_m) {
        return plane.x() + plane.y() * p_B_m.x() + plane.z() * p_B_m.y() + 0.4 - ground_m;
      };
      double points_m = 1e9, nodes_m = 1e9;
      for (const Vec3& point : cost.underside_B_m) {
        const Vec2 p_m = at_m + point.x() * ahead + point.y() * left;
        points_m = std::min(points_m, over_m(point.head<2>(), map.height_m(p_m)));
      }
      for (int row = 0; row < map.rows(); ++row) {
        for (int column = 0; column < map.columns(); ++column) {
          const Vec2 off_m = map.place_m(column, row) - at_m;
          const Vec2 p_B_m(off_m.dot(ahead), off_m.dot(left));
          if (std::abs(p_B_m.x()) > half_m.x() || std::abs(p_B_m.y()) > half_m.y()) continue;
          nodes_m = std::min(nodes_m, over_m(p_B_m, map.node_m(column, row)));
        }
      }
      EXPECT_NEAR(stance.clearance_m, std::min(points_m, nodes_m), 1e-6) << yaw_deg;
      lower += nodes_m < points_m - 0.02;
    }
  }
  EXPECT_GT(lower, 10) << "something stood between the points";
}

TEST(Stance, twin_wheels_are_one_support) {
  const std::vector<Vec2> twins{{2, 1.7}, {2, 1.3}, {2, -1.3}, {2, -1.7}, {-2, 1.5}, {-2, -1.5}};
  EXPECT_EQ(supports_m(twins, 0.85),
            (std::vector<Vec2>{{2, 1.5}, {2, -1.5}, {-2, 1.5}, {-2, -1.5}}));
  EXPECT_EQ(supports_m(twins, 0.7), twins);
}

TEST(Stance, is_a_hazard_beyond_each_limit) {
  DriveCost cost = simple_rover();
  Stance stance;
  EXPECT_EQ(hazard(stance, cost), Hazard::no_ground);
  stance.is_on_ground = true;
  stance.clearance_m = 0.4;
  EXPECT_EQ(hazard(stance, cost), Hazard::none);
  stance.slope_rad = 21 * deg;
  EXPECT_EQ(hazard(stance, cost), Hazard::slope);
  stance.slope_rad = 0;
  stance.unevenness_m = 0.31;
  EXPECT_EQ(hazard(stance, cost), Hazard::uneven);
  stance.unevenness_m = 0;
  stance.clearance_m = 0.09;
  EXPECT_EQ(hazard(stance, cost), Hazard::clearance);
  stance.clearance_m = 0.4;
  cost.soils[0].by_slope.resize(8);  // climbs 5 degrees
  stance.slope_rad = stance.pitch_rad = 6 * deg;
  EXPECT_EQ(hazard(stance, cost), Hazard::climb);
  stance.slope_rad = 12 * deg;
  cost = simple_rover();
  EXPECT_EQ(hazard(stance, cost), Hazard::none);
  // The rover drives down and across a slope that it does not climb, but not across one that is
  // much steeper.
  cost.soils[0].by_slope.resize(8);
  stance.pitch_rad = -12 * deg;
  EXPECT_EQ(hazard(stance, cost), Hazard::none);
  stance.pitch_rad = 0;
  stance.bank_rad = 12 * deg;
  EXPECT_EQ(hazard(stance, cost), Hazard::slide);
  cost = simple_rover();
  cost.limits.slope_max_rad = 40 * deg;
  EXPECT_EQ(hazard(stance, cost), Hazard::none);
  stance.slope_rad = stance.bank_rad = 24 * deg;  // it slips by 0.42 up such a slope
  EXPECT_EQ(hazard(stance, cost), Hazard::slide);
}

TEST(Stance, of_a_hole_between_the_wheels_is_uneven_or_on_its_belly) {
  const Site site({{0, 0, 6, 3, 0.2}});
  const StanceFinder finder(simple_rover());
  GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-20, -20}, {20, 20},
                0.25);
  EXPECT_EQ(hazard(finder.at(map, {10, 0}, {1, 0}), finder.cost()), Hazard::none);
  // One wheel stands in the middle of the hole.
  EXPECT_NE(hazard(finder.at(map, {-1, -0.8}, {1, 0}), finder.cost()), Hazard::none);
}

TEST(GroundMap, has_sampled_what_lies_off_a_window_by_rounding) {
  const Site site({});
  GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-20, -20}, {20, 20},
                0.5);
  // The window begins at the border of a tile: a place on it may be computed to lie before it.
  const auto window = map.window({16, 20}, {18, 22});
  ASSERT_TRUE(window);
  EXPECT_EQ(map.sampled_nodes(), 2u * 9 * 9);
  EXPECT_FALSE(map.window({0, 4}, {2, 6})) << "nor past the edge";
}

TEST(GroundMap, made_coarser_covers_the_same_ground) {
  const Site site({{2, 3, 12, 2, 0.5}});
  GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-20, -10}, {21, 30},
                0.5);
  GroundMap coarser = map.coarser(4);
  EXPECT_DOUBLE_EQ(coarser.spacing_m(), 2);
  EXPECT_EQ(coarser.low_m(), map.low_m());
  const Vec2 high_m = map.place_m(map.columns() - 1, map.rows() - 1);
  EXPECT_GE(coarser.inside_m(high_m), 0);
  EXPECT_LT(coarser.columns() * coarser.rows(), map.columns() * map.rows() / 14);
  for (int row = 0; 4 * row < map.rows(); ++row) {
    for (int column = 0; 4 * column < map.columns(); ++column) {
      EXPECT_EQ(coarser.node_m(column, row), map.node_m(4 * column, 4 * row));
    }
  }
}

}  // namespace
}  // namespace lsos::test
