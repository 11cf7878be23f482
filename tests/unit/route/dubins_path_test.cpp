// Arcs against geometry, and routes of a rover that cannot turn on the spot.
#include "route/search/pose_search.h"

#include <gmock/gmock.h>

#include "base/random.h"
#include "route/search/grid_search.h"
#include "test_turner.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// The tightest circle through three neighbours of a line.
double radius_min_m(const Path3& line) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const Vec2 a = (line[k] - line[k - 1]).head<2>(), b = (line[k + 1] - line[k]).head<2>();
    const double twice_area = std::abs(a.x() * b.y() - a.y() * b.x());
    if (twice_area < 1e-9) continue;
    least_m = std::min(least_m, a.norm() * b.norm() * (a + b).norm() / (2 * twice_area));
  }
  return least_m;
}

TEST(Arc, of_a_quarter_circle_ends_a_radius_ahead_and_aside) {
  const Pose2 left = along_arc({{1, 2}, 0}, 0.25, 4 * pi / 2);
  EXPECT_NEAR((left.at_m - Vec2(5, 6)).norm(), 0, 1e-12);
  EXPECT_NEAR(left.yaw_rad, pi / 2, 1e-12);
  const Pose2 right = along_arc({{0, 0}, pi / 2}, -0.25, 4 * pi);
  EXPECT_NEAR((right.at_m - Vec2(8, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((along_arc({{0, 0}, pi}, 0, 3).at_m - Vec2(-3, 0)).norm(), 0, 1e-12);
}

TEST(ShortestTurns, below_a_bound_are_those_without_and_above_it_none) {
  RandomStream random(11);
  for (int k = 0; k < 2000; ++k) {
    const Pose2 from{{random.uniform(-9, 9), random.uniform(-9, 9)}, random.uniform(-pi, pi)};
    // Half of the poses lie on a circle of the first.
    const Pose2 to =
        k % 2 == 0 ? along_arc(from, k % 4 == 0 ? 0.25 : -0.25, random.uniform(0.1, 25))
                   : Pose2{{random.uniform(-9, 9), random.uniform(-9, 9)}, random.uniform(-pi, pi)};
    const double least_m = length_m(dubins_path(from, to, 4));
    const auto bounded = dubins_path(PosePair(from, to), 4, 1.001 * least_m + 1e-4);
    ASSERT_TRUE(bounded) << k;
    EXPECT_NEAR(length_m(*bounded), least_m, 1e-9);
    EXPECT_FALSE(dubins_path(PosePair(from, to), 4, 0.999 * least_m - 1e-4)) << k;
  }
}

// Both circles are the same, and the straight piece has no direction.
TEST(ShortestTurns, along_one_circle_are_its_arc) {
  RandomStream random(7);
  for (int k = 0; k < 1000; ++k) {
    const Pose2 from{{random.uniform(-50, 50), random.uniform(-50, 50)}, random.uniform(-pi, pi)};
    const double arc_m = 4 * random.uniform(0.01, 1.2 * pi);
    const Pose2 to = along_arc(from, k % 2 == 0 ? 0.25 : -0.25, arc_m);
    EXPECT_NEAR(length_m(dubins_path(from, to, 4)), arc_m, 1e-5);
  }
}

// Every point of the arc is a radius from its centre, and the straight piece leaves at a right
// angle to that radius.
TEST(ArcAndStraight, is_a_tangent) {
  for (const bool to_left : {true, false}) {
    for (const double yaw_rad : {0.0, 1.0, 3.0, -2.0}) {
      const Pose2 from{{2, -1}, yaw_rad};
      const Vec2 to_m(30, 12);
      const auto line = arc_and_straight(from, to_m, 4, to_left, 0.1);
      ASSERT_TRUE(line);
      const Vec2 ahead = from.ahead();
      const Vec2 center_m = from.at_m + (to_left ? 4 : -4) * Vec2(-ahead.y(), ahead.x());
      for (std::size_t k = 0; k + 1 < line->size(); ++k) {
        EXPECT_NEAR(((*line)[k] - center_m).norm(), 4, 1e-9);
      }
      const Vec2 leaves_m = (*line)[line->size() - 2];
      EXPECT_NEAR((leaves_m - center_m).dot(to_m - leaves_m), 0, 1e-6);
      // It leaves ahead, not backwards.
      const Vec2 last = leaves_m - (line->size() > 2 ? (*line)[line->size() - 3] : leaves_m);
      EXPECT_GE(last.dot(to_m - leaves_m), 0);
    }
  }
  EXPECT_FALSE(arc_and_straight({{0, 0}, 0}, {0, 3}, 4, true, 0.1));
}

// The path ends in the pose and is not longer than any of arc, straight piece and arc found by
// trial: a first arc of every angle, then the tangent to either circle at the end.
TEST(ShortestTurns, end_in_the_pose_and_nothing_shorter_is_found) {
  RandomStream random(5);
  constexpr double r = 3;
  for (int k = 0; k < 300; ++k) {
    const Pose2 from{{random.uniform(-20, 20), random.uniform(-20, 20)}, random.uniform(-4, 4)};
    const Pose2 to{{random.uniform(-20, 20), random.uniform(-20, 20)}, random.uniform(-4, 4)};
    const DubinsPath way = dubins_path(from, to, r);
    const Pose2 end = along_dubins(from, way, length_m(way));
    EXPECT_NEAR((end.at_m - to.at_m).norm(), 0, 1e-5);
    EXPECT_NEAR(std::remainder(end.yaw_rad - to.yaw_rad, 2 * pi), 0, 1e-6);
    double least_m = std::numeric_limits<double>::infinity();
    for (const double first : {1.0, -1.0}) {
      for (const double last : {1.0, -1.0}) {
        const Vec2 ahead = to.ahead();
        const Vec2 center_m = to.at_m + last * r * Vec2(-ahead.y(), ahead.x());
        for (double turned = 0; turned < 2 * pi; turned += 1e-3) {
          const Pose2 leaves = along_arc(from, first / r, turned * r);
          // Straight on, the line touches the last circle where its distance is the radius.
          const Vec2 to_center_m = center_m - leaves.at_m;
          const double on_m = to_center_m.dot(leaves.ahead());
          const double aside_m =
              leaves.ahead().x() * to_center_m.y() - leaves.ahead().y() * to_center_m.x();
          if (on_m < 0 || std::abs(aside_m - last * r) > 5e-3) continue;
          double rest = std::remainder(last * (to.yaw_rad - leaves.yaw_rad), 2 * pi);
          if (rest < -1e-2) rest += 2 * pi;
          least_m = std::min(least_m, turned * r + on_m + std::max(0.0, rest) * r);
        }
      }
    }
    EXPECT_LT(length_m(way), least_m + 0.05);
  }
}

// Over a thousand radii straight ahead the path is straight, without a full turn.
TEST(ShortestTurns, far_ahead_are_straight) {
  for (double yaw_rad = 0.01; yaw_rad < 6.3; yaw_rad += 0.37) {
    const Pose2 from{{1, 2}, yaw_rad};
    const Pose2 to{from.at_m + 3000 * from.ahead(), yaw_rad};
    EXPECT_NEAR(length_m(dubins_path(from, to, 3)), 3000, 1e-2);
    EXPECT_NEAR(length_m(dubins_path(from, from, 3)), 0, 1e-5);
  }
}

TEST(TurningPlan, ahead_over_level_ground_is_straight_and_behind_is_round) {
  const Site site({});
  const DriveCost cost = wide_turner();
  const PlannedLeg ahead = plan_leg(site.ground(), cost, towards({0, 40, 0}, 0));
  ASSERT_TRUE(ahead.is_found()) << ahead.reason;
  EXPECT_NEAR(ahead.length_m, 40, 0.05);
  EXPECT_NEAR(ahead.end_heading_rad, 0, 0.01);
  // Shortest path: round an arc whose tangent meets the goal, with a radius r and the goal d
  // straight behind. The centre of the left circle is h = hypot(d, r) from the goal.
  const double r = turning_margin * 4, d = 40, h = std::hypot(d, r);
  const double shortest_m =
      r * (1.5 * pi + std::atan2(r, d) - std::acos(r / h)) + std::sqrt(h * h - r * r);
  const PlannedLeg behind = plan_leg(site.ground(), cost, towards({0, -40, 0}, 0));
  ASSERT_TRUE(behind.is_found()) << behind.reason;
  EXPECT_GT(behind.length_m, 0.995 * shortest_m);
  EXPECT_LT(behind.length_m, 1.02 * shortest_m);
}

TEST(TurningPlan, goes_around_what_is_too_steep_in_arcs_that_it_can_drive) {
  const Site site({{30, 4, 24, 5, 0.5}, {62, -12, 40, 0, 5}, {50, 18, 12, 2.5, 0.3}});
  const DriveCost cost = wide_turner();
  for (const double heading_rad : {pi / 2, 0.0, -pi / 2}) {
    const PlannedLeg leg = plan_leg(site.ground(), cost, towards({100, 0, 0}, heading_rad));
    ASSERT_TRUE(leg.is_found()) << leg.reason;
    EXPECT_GT(radius_min_m(leg.path_S_m), 4);
    EXPECT_LT(leg.slope_max_rad, cost.limits.slope_max_rad);
    const Vec3 first = leg.path_S_m[1] - leg.path_S_m[0];
    const double left_by_rad = std::atan2(first.x(), first.y()) - heading_rad;
    EXPECT_LT(std::abs(std::remainder(left_by_rad, 2 * pi)), 0.15) << "it begins as it stands";
    EXPECT_NEAR((leg.path_S_m.back() - Vec3(100, 0, 0)).norm(), 0, 0.1);
  }
}

TEST(TurningPlan, is_the_same_every_time) {
  const Site site({{30, 4, 24, 5, 0.5}});
  const LegRequest request = towards({60, 5, 0}, 1);
  const PlannedLeg first = plan_leg(site.ground(), wide_turner(), request);
  const PlannedLeg again = plan_leg(site.ground(), wide_turner(), request);
  EXPECT_EQ(first.cost, again.cost);
  EXPECT_EQ(first.path_S_m, again.path_S_m);
}

TEST(TurningPlan, says_that_a_ring_of_walls_is_in_the_way) {
  const Site site({{60, 0, 40, 14, 2}});
  const PlannedLeg leg = plan_leg(site.ground(), wide_turner(), towards({60, 0, 0}, pi / 2));
  EXPECT_FALSE(leg.is_found());
  EXPECT_THAT(leg.reason, HasSubstr("no route comes nearer to the goal than "));
}

TEST(SearchTurning, leaves_a_ring_ahead_but_not_behind) {
  OpenGround ahead(30, ring(8, 0)), behind(30, ring(8, pi));
  const PoseRoute out = search_poses(ahead.costs, {Vec2::Zero(), 0}, {50, 0}, turn_m, many_poses);
  EXPECT_TRUE(out.is_found());
  const PoseRoute none = search_poses(behind.costs, {Vec2::Zero(), 0}, {50, 0}, turn_m, many_poses);
  EXPECT_FALSE(none.is_found());
  EXPECT_FALSE(none.is_at_border) << "no wider map helps";
  EXPECT_FALSE(none.is_start_blocked);
  EXPECT_LT(none.nearest_m.norm(), 8);
}

// The cost to go downhill is 0, and yet there is room to turn.
TEST(SearchTurning, heading_up_a_slope_turns_round) {
  for (const double slope_deg : {5, 10, 11, 12, 15}) {
    OpenGround ground(30, {{{20, 0}, 3}}, slope_deg * deg);
    const Pose2 uphill{{10, 0}, pi};
    for (const double goal_m : {6, 20, 50}) {
      EXPECT_TRUE(
          search_poses(ground.costs, uphill, {10 + 0.8 * goal_m, 5}, turn_m, many_poses).is_found())
          << slope_deg << " deg, " << goal_m << " m";
    }
  }
}

TEST(SearchTurning, comes_to_a_goal_close_abeam) {
  OpenGround ground(30, {});
  for (const Vec2& goal_m : {Vec2(20, 0.5), Vec2(20, 1), Vec2(20, -1), Vec2(19, 2)}) {
    EXPECT_TRUE(search_poses(ground.costs, {{20, 0}, 0}, goal_m, turn_m, many_poses).is_found())
        << goal_m.transpose();
  }
}

TEST(SearchTurning, that_had_no_room_to_turn_round_says_that_the_map_was_too_narrow) {
  OpenGround narrow(4, {}), wide(10, {});
  const Pose2 away{{30, 0}, 0};
  const PoseRoute none = search_poses(narrow.costs, away, {0, 0}, turn_m, many_poses);
  EXPECT_FALSE(none.is_found());
  EXPECT_TRUE(none.is_at_border);
  EXPECT_TRUE(search_poses(wide.costs, away, {0, 0}, turn_m, many_poses).is_found());
}

// Walls have gaps far to the left and to the right alternately: whole rooms are expanded in vain.
TEST(SearchTurning, with_a_greater_weight_finds_a_route_through_walls) {
  const auto walls = [](int count) {
    std::vector<Disc2> discs;
    for (int wall = 1; wall <= count; ++wall) {
      const double gap_m = wall % 2 == 0 ? 30 : -30;
      for (double y_m = -70; y_m <= 70; y_m += 0.5) {
        if (std::abs(y_m - gap_m) > 2) discs.push_back({{8.5 * wall, y_m}, 1});
      }
    }
    return discs;
  };
  OpenGround few(30, walls(1)), many(70, walls(6));
  const Pose2 start{Vec2::Zero(), 0};
  const Vec2 goal_m(56, 0);
  const PoseRoute easy = search_poses(few.costs, start, goal_m, turn_m, many_poses);
  const PoseRoute hard = search_poses(many.costs, start, goal_m, turn_m, many_poses);
  ASSERT_TRUE(easy.is_found());
  ASSERT_TRUE(hard.is_found());
  EXPECT_TRUE(std::isfinite(many.costs.along(hard.stretches.front().line)));
  const double over_lattice = search_grid(many.costs, start.at_m, goal_m).cost;
  std::printf("heuristic weights %.2f and %.2f, %.3f of the cost over the lattice\n", easy.weight,
              hard.weight, hard.cost / over_lattice);
  EXPECT_LT(easy.weight, hard.weight);
  EXPECT_LT(hard.cost, 1.2 * over_lattice) << "it winds between the walls";
  EXPECT_FALSE(search_poses(many.costs, start, goal_m, turn_m, 20).is_found())
      << "so few poses do not lead there";
}

TEST(SearchTurning, by_a_coarse_guide_is_as_good_and_looks_at_less) {
  std::vector<Disc2> discs;
  for (int k = 0; k < 4; ++k) discs.push_back({{12.0 * k + 10, k % 3 - 1.0}, 3});
  const Pose2 start{Vec2::Zero(), 0.5};
  const Vec2 goal_m(56, 4);
  OpenGround fine(30, discs), coarse(30, discs);
  const Corridor corridor(fine.map, {start.at_m, goal_m}, 20);
  const PoseRoute by_fine =
      search_poses(fine.costs, start, goal_m, turn_m, many_poses, {&corridor, false});
  const PoseRoute by_coarse =
      search_poses(coarse.costs, start, goal_m, turn_m, many_poses, {&corridor, true});
  ASSERT_TRUE(by_fine.is_found());
  ASSERT_TRUE(by_coarse.is_found());
  EXPECT_TRUE(std::isfinite(coarse.costs.along(by_coarse.stretches.front().line)));
  EXPECT_LT(by_coarse.cost, 1.2 * by_fine.cost);
  EXPECT_LT(coarse.map.sampled_nodes(), fine.map.sampled_nodes());
}

TEST(PlanLeg, keeps_off_places_that_are_avoided) {
  const Site site({});
  LegRequest request = towards({60, 0, 0}, 0);
  request.avoided = {{{30, 1, 0}, 5}};
  for (DriveCost cost : {simple_rover(), wide_turner()}) {
    request.start_heading_rad = pi / 2;
    const PlannedLeg leg = plan_leg(site.ground(), cost, request);
    ASSERT_TRUE(leg.is_found()) << leg.reason;
    for (std::size_t k = 0; k + 1 < leg.path_S_m.size(); ++k) {
      for (double share = 0; share <= 1; share += 0.05) {
        const Vec3 p_m = leg.path_S_m[k] + share * (leg.path_S_m[k + 1] - leg.path_S_m[k]);
        EXPECT_GT((p_m - Vec3(30, 1, 0)).head<2>().norm(), 4.8);
      }
    }
    EXPECT_LT(leg.length_m, 63);
  }
}

TEST(IsFree, tells_level_ground_from_a_wall) {
  const Site site({{30, 0, 24, 5, 0.5}});
  EXPECT_TRUE(is_free(site.ground(), simple_rover(), {}, {0, 0, 0}, {4, 3, 0}));
  EXPECT_FALSE(is_free(site.ground(), simple_rover(), {}, {14, 0, 0}, {24, 0, 0}));
}

TEST(IsFree, tells_open_ground_from_what_stands_there) {
  const Site site({});
  Obstacles obstacles;
  obstacles.rover_at_rest.half_m = {1, 0.8};
  obstacles.standing = {{"Hab", {10, 0, 0}, {0, 1, 0}, {3, 1}}};  // 2 m wide, 6 m north to south
  const auto free_to = [&](const Vec3& from_S_m, const Vec3& to_S_m) {
    return is_free(site.ground(), simple_rover(), obstacles, from_S_m, to_S_m);
  };
  EXPECT_FALSE(free_to({4, 0, 0}, {16, 0, 0}));
  EXPECT_FALSE(free_to({4, 3.5, 0}, {16, 3.5, 0}));
  // Half the diagonal is 1.28 m, and the rover keeps 0.4 m more.
  EXPECT_TRUE(free_to({4, 4.8, 0}, {16, 4.8, 0}));
}

}  // namespace
}  // namespace lsos::test
