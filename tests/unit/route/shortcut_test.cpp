// Dubins paths made cheaper by leaving out poses, on level ground.
#include "route/refine/shortcut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/route/test_rover.h"

namespace lsos::test {
namespace {

constexpr double radius_m = 4;

// A rover to which slowing down for an arc costs as much as 3 m of the level.
struct DubinsRover {
  DubinsRover() {
    cost.can_turn_on_spot = false;
    cost.turning_radius_min_m = radius_m;
    cost.speed_mps = cost.level_speed_mps = 2;
    cost.stop_s = 4;
    cost.slow_j = 3000;
  }
  double of(const std::vector<Pose2>& poses) { return costs.driven(steering.line(poses)); }

  Site site{{}};
  DriveCost cost = simple_rover();
  StanceFinder finder{cost};
  GroundMap map{
      site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-60, -60}, {60, 60}, 0.5};
  RouteCost costs{map, finder, RouteAim::energy};
  RouteSteering steering =
      RouteSteering::dubins(radius_m, 0.5, [&](double of_m) { return arc_price_m(cost, of_m); });
};

TEST(FewerPoses, of_an_arc_in_many_pieces_cost_no_more_than_the_arc) {
  DubinsRover rover;
  std::vector<Pose2> poses{{{0, 0}, 0}};
  for (int k = 0; k < 20; ++k) poses.push_back(along_arc(poses.back(), 1 / (2 * radius_m), 0.6));
  const std::vector<Pose2> arc{poses.front(), poses.back()};
  const auto fewer = shortcut(rover.costs, rover.steering, poses);
  EXPECT_LT(fewer.size(), poses.size());
  EXPECT_LE(rover.of(fewer), rover.of(poses));
  EXPECT_LT(rover.of(fewer), 1.01 * rover.of(arc));
}

// Poses wind from side to side where the straight line is free.
TEST(FewerPoses, of_a_winding_way_are_nearly_the_straight_one) {
  DubinsRover rover;
  std::vector<Pose2> poses{{{0, 0}, 0}};
  for (int k = 0; k < 40; ++k) {
    poses.push_back(
        {{1.0 * (k + 1), 0.4 * std::sin(0.9 * (k + 1))}, 0.36 * std::cos(0.9 * (k + 1))});
  }
  const double winding = rover.of(poses);
  ASSERT_TRUE(std::isfinite(winding));
  const double straight = rover.costs.straight(poses.front().at_m, poses.back().at_m);
  const auto fewer = shortcut(rover.costs, rover.steering, poses);
  EXPECT_LT(rover.of(fewer), 0.6 * winding);
  EXPECT_LT(rover.of(fewer), 1.3 * straight);
  EXPECT_EQ(fewer.front().at_m, poses.front().at_m);
  EXPECT_EQ(fewer.back().at_m, poses.back().at_m);
}

}  // namespace
}  // namespace lsos::test
