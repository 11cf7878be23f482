// Routes of a rover that cannot turn on the spot and backs up where no route leads forwards.
#include <gmock/gmock.h>

#include "route/car_route.h"
#include "route/refine/simplify.h"
#include "route/search/pose_search.h"
#include "test_turner.h"

namespace lsos::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PoseGuide with_reverse() {
  PoseGuide guide;
  guide.may_reverse = true;
  return guide;
}

double line_length_m(const Line2& line) {
  double sum_m = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) sum_m += (line[k + 1] - line[k]).norm();
  return sum_m;
}

// Between two walls that leave no room to turn round.
struct Lane {
  explicit Lane(double aside_m) : ground(aside_m + 3, walls(aside_m)) {}
  static std::vector<Disc2> walls(double aside_m) {
    std::vector<Disc2> discs;
    for (double x_m = -10; x_m <= 60; x_m += 0.5) {
      discs.push_back({{x_m, aside_m + 1}, 1});
      discs.push_back({{x_m, -aside_m - 1}, 1});
    }
    return discs;
  }
  OpenGround ground;
};

TEST(BackingRoute, backs_out_of_a_ring_that_is_open_behind) {
  OpenGround behind(30, ring(8, pi));
  const PoseRoute out =
      search_poses(behind.costs, {Vec2::Zero(), 0}, {50, 0}, turn_m, many_poses, with_reverse());
  ASSERT_TRUE(out.is_found());
  EXPECT_TRUE(out.stretches.front().is_backward);
  EXPECT_FALSE(out.stretches.back().is_backward);
  EXPECT_TRUE(std::isfinite(driven(behind.costs, out.stretches)));
  for (std::size_t k = 1; k < out.stretches.size(); ++k) {
    const Stretch &before = out.stretches[k - 1], &after = out.stretches[k];
    EXPECT_NE(before.is_backward, after.is_backward);
    EXPECT_EQ(before.line.back(), after.line.front());
    // The rover stands as it came.
    const double turned_rad = standing(before.poses.back(), before.is_backward).yaw_rad -
                              standing(after.poses.front(), after.is_backward).yaw_rad;
    EXPECT_NEAR(std::remainder(turned_rad, 2 * pi), 0, 1e-9);
  }
}

// The shortest path of Reeds and Shepp to a place straight behind is straight.
TEST(BackingRoute, backs_straight_to_a_place_behind) {
  Lane lane(2);
  const PoseRoute back =
      search_poses(lane.ground.costs, {{30, 0}, 0}, {24, 0}, turn_m, many_poses, with_reverse());
  ASSERT_EQ(back.stretches.size(), 1u);
  EXPECT_TRUE(back.stretches.front().is_backward);
  EXPECT_NEAR(line_length_m(back.stretches.front().line), 6, 0.05);
  Lane same(2);
  EXPECT_FALSE(
      search_poses(same.ground.costs, {{30, 0}, 0}, {24, 0}, turn_m, many_poses).is_found());
}

TEST(BackingRoute, comes_to_a_place_inside_its_turning_circle) {
  // The tightest circle about (30, 4.4) leaves no way forwards to a place 1 to 2 m abeam.
  for (const Vec2& goal_m : {Vec2(30.5, 1.5), Vec2(30, 1), Vec2(31, -1.5)}) {
    Lane lane(3), same(3);
    const Pose2 start{{30, 0}, 0};
    EXPECT_FALSE(search_poses(same.ground.costs, start, goal_m, turn_m, many_poses).is_found());
    const PoseRoute found =
        search_poses(lane.ground.costs, start, goal_m, turn_m, many_poses, with_reverse());
    ASSERT_TRUE(found.is_found()) << goal_m.transpose();
    EXPECT_EQ(found.stretches.back().line.back(), goal_m);
    EXPECT_TRUE(std::isfinite(driven(lane.ground.costs, found.stretches)));
  }
}

TEST(BackingRoute, costs_a_stop_and_metres_more_for_a_change_of_gear) {
  OpenGround open(20, {});
  open.cost.stop_j = 500;
  open.cost.stop_s = 4;
  open.cost.idle_w = 10;
  const StanceFinder finder(open.cost);
  RouteCost costs(open.map, finder, RouteAim::energy);
  const Stretches forwards{{{}, {{0, 0}, {10, 0}}, false}};
  const Stretches there_and_back{{{}, {{0, 0}, {10, 0}}, false}, {{}, {{10, 0}, {4, 0}}, true}};
  const LegSummary one = summary(costs, forwards), two = summary(costs, there_and_back);
  const double metre_j = one.energy_j / 10;
  const double change_s = 4 + 1 + 1 / (4 * 0.2);  // to stop, and to steer to a radius of 4 m
  EXPECT_NEAR(two.length_m, 16, 1e-9);
  EXPECT_NEAR(two.energy_j, 16 * metre_j + 500 + 10 * change_s, 1e-6);
  EXPECT_NEAR(two.duration_s, 1.6 * one.duration_s + change_s, 1e-6);
  // What it is chosen by: a metre backwards counts twice, and a change as five on the level.
  EXPECT_NEAR(two.cost, (10 + 2 * 6 + 5) * metre_j + 500 + 10 * change_s, 5 * 10 + 1e-6);
  EXPECT_EQ(two.cost, driven(costs, there_and_back));
}

TEST(BackingRoute, joins_stretches_and_names_where_the_gear_changes) {
  const GearedLine line = corners(Stretches{{{}, {{0, 0}, {-1, 0}, {-2, 0}}, true},
                                            {{}, {{-2, 0}, {4, 0}, {6, 1}}, false},
                                            {{}, {{6, 1}, {5, 1}}, true}});
  EXPECT_THAT(line.line, ElementsAre(Vec2(0, 0), Vec2(-2, 0), Vec2(4, 0), Vec2(6, 1), Vec2(5, 1)));
  EXPECT_THAT(line.gear_changes, ElementsAre(0u, 1u, 3u));
  EXPECT_THAT(corners(Stretches{{{}, {{0, 0}, {1, 0}}, false}}).gear_changes, IsEmpty());
}

TEST(BackingRoute, without_poses_left_is_not_told_as_a_start_that_is_blocked) {
  OpenGround behind(30, ring(8, pi));
  for (std::size_t poses_left : {std::size_t{0}, std::size_t{3}, many_poses}) {
    const bool is_enough = poses_left == many_poses;
    const CarRoute route =
        car_route(behind.costs, behind.cost, {Vec2::Zero(), 0}, {50, 0}, turn_m, 1, poses_left);
    EXPECT_EQ(route.is_found(), is_enough);
    EXPECT_EQ(route.is_turn_too_wide, !is_enough);
    EXPECT_FALSE(route.is_start_blocked);
    EXPECT_LT(poses_left, many_poses);
  }
}

// Boxes ahead of the rover and beside it; the goal lies beyond them, or behind.
LegRequest parked_in(double goal_x_m) {
  LegRequest request = towards({goal_x_m, 0, 0}, pi / 2);
  request.obstacles.rover_at_rest.half_m = {1.5, 1};
  request.obstacles.standing = {{"Front", {4.5, 0, 0}, {1, 0, 0}, {1, 6}},
                                {"Left", {0, 4, 0}, {1, 0, 0}, {3.4, 1}},
                                {"Right", {0, -4, 0}, {1, 0, 0}, {3.4, 1}}};
  return request;
}

TEST(PlanLeg, backs_out_of_where_the_rover_is_parked) {
  const Site site({});
  const LegRequest request = parked_in(40);
  const PlannedLeg leg = plan_leg(site.ground(), wide_turner(), request);
  ASSERT_TRUE(leg.is_found()) << leg.reason;
  ASSERT_TRUE(leg.begins_backwards());
  EXPECT_FALSE(leg.ends_backwards());
  EXPECT_LT(leg.path_S_m[1].x(), leg.path_S_m[0].x());
  for (const std::size_t at : leg.gear_changes) EXPECT_LT(at + 1, leg.path_S_m.size());
  const PlannedLeg again = plan_leg(site.ground(), wide_turner(), request);
  EXPECT_EQ(leg.path_S_m, again.path_S_m);
  EXPECT_EQ(leg.gear_changes, again.gear_changes);
  // A rover that ends a leg backwards faces away from where it came.
  const PlannedLeg back = plan_leg(site.ground(), wide_turner(), parked_in(-6));
  ASSERT_TRUE(back.is_found()) << back.reason;
  EXPECT_TRUE(back.ends_backwards());
  EXPECT_NEAR(back.end_heading_rad, pi / 2, 0.3);
}

TEST(PlanLeg, says_that_a_rover_without_room_ahead_and_behind_cannot_set_off) {
  const Site site({});
  LegRequest request = parked_in(40);
  request.obstacles.rover_at_rest.half_m = {2, 1};
  request.obstacles.standing = {{"Front", {3.2, 0, 0}, {1, 0, 0}, {1, 0.5}},
                                {"Back", {-3.2, 0, 0}, {1, 0, 0}, {1, 0.5}}};
  const PlannedLeg leg = plan_leg(site.ground(), wide_turner(), request);
  EXPECT_FALSE(leg.is_found());
  EXPECT_THAT(leg.reason, HasSubstr("neither forwards nor backwards"));
}

}  // namespace
}  // namespace lsos::test
