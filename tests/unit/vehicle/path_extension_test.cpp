// How the line of a path follower grows while it is driven.
#include <gtest/gtest.h>

#include "test_site.h"
#include "vehicle/path_follower.h"

namespace lsos {
namespace {

using test::period_s;

// A point that moves as it is commanded.
struct Walk {
  explicit Walk(const Path3& path, const FollowerLimits& limits) : follower(path, pose, limits) {}

  void step() {
    const DriveCommand command = follower.update(pose, period_s);
    pose.speed_mps = command.is_braking ? 0 : command.speed_mps;
    pose.yaw_rad += period_s * (command.is_braking ? 0 : command.yaw_rate_radps);
    pose.p_S_m += period_s * pose.speed_mps * Vec2(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
  }

  FollowerPose pose{{0, 0}};
  PathFollower follower;
};

TEST(PathExtension, goes_on_to_the_new_end_and_counts_what_is_left) {
  FollowerLimits limits;
  limits.speed_mps = limits.level_speed_mps = 1;
  Walk walk({{20, 0, 0}}, limits);
  for (int i = 0; i < 100; ++i) walk.step();
  walk.follower.extend({{20, 0}, {40, 0}}, walk.pose);
  EXPECT_NEAR(walk.follower.remaining_m(), 40 - walk.pose.p_S_m.x(), 1e-6);
  while (walk.follower.status() == PathFollower::Status::driving) walk.step();
  EXPECT_EQ(walk.follower.status(), PathFollower::Status::arrived);
  EXPECT_NEAR(walk.pose.p_S_m.x(), 40, 0.1);
}

// What lies more than ten metres behind is forgotten, also where the corners that are left are
// rounded otherwise without it.
TEST(PathExtension, keeps_its_place_while_it_forgets_what_it_has_driven) {
  FollowerLimits limits;
  limits.speed_mps = limits.level_speed_mps = 1;
  limits.can_turn_on_spot = false;
  limits.radius_min_m = 2;
  const auto corner = [](int i) { return Vec2(3.0 * i, i % 2 == 0 ? 0 : 0.8); };
  std::vector<Vec2> line{{0, 0}};
  for (int i = 1; i <= 4; ++i) line.push_back(corner(i));
  Path3 path;
  for (std::size_t i = 1; i < line.size(); ++i) path.push_back({line[i].x(), line[i].y(), 0});
  Walk walk(path, limits);
  int next = 5;
  double longest_jump_m = 0;
  for (int i = 0; i < 6000 && walk.follower.status() == PathFollower::Status::driving; ++i) {
    const double before_m = walk.follower.remaining_m();
    walk.step();
    longest_jump_m = std::max(longest_jump_m, std::abs(walk.follower.remaining_m() - before_m));
    if (next <= 40 && walk.follower.remaining_m() < 6) {
      const std::size_t waypoint = walk.follower.next_waypoint();
      walk.follower.extend({corner(next - 1), corner(next)}, walk.pose);
      ++next;
      // The waypoint ahead keeps its number, and the way to the end is about as long as the line.
      EXPECT_NEAR(static_cast<double>(walk.follower.next_waypoint()), static_cast<double>(waypoint),
                  1)
          << next;
      const double left_m = (corner(next - 1).x() - walk.pose.p_S_m.x()) * std::hypot(3, 0.8) / 3;
      EXPECT_NEAR(walk.follower.remaining_m(), left_m, 0.4) << next;
    }
    const double way = walk.pose.p_S_m.x() / 3 - std::floor(walk.pose.p_S_m.x() / 3);
    const bool rises = static_cast<int>(walk.pose.p_S_m.x() / 3) % 2 == 0;
    EXPECT_NEAR(walk.pose.p_S_m.y(), 0.8 * (rises ? way : 1 - way), 0.4);
  }
  EXPECT_EQ(walk.follower.status(), PathFollower::Status::arrived) << walk.follower.reason();
  EXPECT_NEAR((walk.pose.p_S_m - corner(40)).norm(), 0, 0.5);
  EXPECT_LT(longest_jump_m, 0.5);
}

}  // namespace
}  // namespace lsos
