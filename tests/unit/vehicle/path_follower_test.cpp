#include "vehicle/path_follower.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/segment.h"
#include "base/units.h"
#include "driving/fillet.h"
#include "test_rover.h"
#include "test_site.h"
#include "vehicle/vehicle.h"

namespace lsos {
namespace {

using test::period_s;

double distance_to_line_m(const Vec2& p, const std::vector<Vec2>& line) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    nearest = std::min(nearest, point_distance_m(line[i], line[i + 1], p));
  }
  return nearest;
}

struct Drive {
  PathFollower::Status status = PathFollower::Status::driving;
  double worst_m = 0;  // greatest cross-track error
  double to_goal_m = 0;
  double yaw_rad = 0;
  std::string reason;
};

Drive drive(const Ground& ground, const std::vector<Vec2>& waypoints, double heading_rad,
            bool is_crabbing = false) {
  Vehicle vehicle(test::rover(test::moon_g_mps2), ground);
  EXPECT_EQ(vehicle.place({0.1, 0.2, 0}, heading_rad), "");
  const auto pose = [&] {
    const VehicleReport report = vehicle.report();
    const Vec2 left_S(-std::sin(report.yaw_rad), std::cos(report.yaw_rad));
    return FollowerPose{report.p_S_m.head<2>(), report.yaw_rad, report.speed_mps,
                        left_S.dot(report.v_S_mps.head<2>())};
  };
  Path3 path;
  std::vector<Vec2> line{Vec2::Zero()};
  for (const Vec2& p : waypoints) {
    path.push_back({p.x(), p.y(), 0});
    line.push_back(p);
  }
  FollowerLimits limits;
  limits.speed_mps = 2;
  limits.acceleration_mps2 = 0.3;
  limits.is_crabbing = is_crabbing;
  PathFollower follower(path, pose(), limits);
  Drive result;
  for (int i = 0; i < 20000 && follower.status() == PathFollower::Status::driving; ++i) {
    vehicle.command(follower.update(pose(), period_s));
    vehicle.advance(exchange_period);
    result.worst_m = std::max(result.worst_m, distance_to_line_m(pose().p_S_m, line));
  }
  result.status = follower.status();
  result.reason = follower.reason();
  result.yaw_rad = pose().yaw_rad;
  result.to_goal_m = (pose().p_S_m - line.back()).norm();
  return result;
}

TEST(PathFollower, holds_a_line_with_corners_and_stops_at_its_end) {
  const auto ground = test::moon();
  const Drive result =
      drive(*ground, {{40, 0}, {40, 30}, {70, 45}, {100, 50}, {60, 80}}, radians(90));
  EXPECT_EQ(result.status, PathFollower::Status::arrived) << result.reason;
  EXPECT_LT(result.worst_m, 0.3);
  EXPECT_LT(result.to_goal_m, 0.3);
}

// The rover is placed, not driven: 1 m/s along x at a distance from the line.
TEST(PathFollower, fails_when_it_strays_farther_than_it_may) {
  FollowerLimits limits;
  limits.cross_track_max_m = 2;
  const Path3 path{{10, 0, 0}, {20, 0, 0}, {20, 10, 0}};
  PathFollower follower(path, {{0, 0}, 0, 1, 0}, limits);
  follower.update({{4, 1.9}, 0, 1, 0}, period_s);
  EXPECT_EQ(follower.status(), PathFollower::Status::driving);
  EXPECT_EQ(follower.next_waypoint(), 0u);
  follower.update({{12, -1.9}, 0, 1, 0}, period_s);
  EXPECT_EQ(follower.status(), PathFollower::Status::driving);
  EXPECT_EQ(follower.next_waypoint(), 1u);
  follower.update({{13, -2.1}, 0, 1, 0}, period_s);
  EXPECT_EQ(follower.status(), PathFollower::Status::failed);
  EXPECT_TRUE(follower.is_off_line());
  EXPECT_FALSE(follower.is_stuck());
  EXPECT_EQ(follower.reason(), "strayed 2.1 m from its path, 17.0 m before the end");
  EXPECT_EQ(follower.next_waypoint(), 1u);
}

// Waypoints on which the rover stands at the start are passed, but keep their numbers.
TEST(PathFollower, counts_waypoints_as_they_were_given) {
  PathFollower follower({{0.5, 0, 0}, {10, 0, 0}, {20, 0, 0}}, {{0, 0}, 0, 0, 0}, {});
  EXPECT_EQ(follower.next_waypoint(), 1u);
  follower.update({{15, 0}, 0, 1, 0}, period_s);
  EXPECT_EQ(follower.next_waypoint(), 2u);
}

// A rover that was put elsewhere goes on with the waypoint behind the nearest place of its path.
TEST(PathFollower, begins_again_where_the_rover_was_put) {
  const Path3 path{{50, 0, 0}, {50, 40, 0}, {0, 40, 0}};
  const auto next_after = [&](const Vec2& from_S_m, const Vec2& to_S_m) {
    PathFollower follower(path, {{0, 0}, 0, 0, 0}, {});
    follower.update({from_S_m, 0, 1, 0}, period_s);
    follower.begin_again({to_S_m, 0, 0, 0});
    EXPECT_EQ(follower.status(), PathFollower::Status::driving);
    follower.update({to_S_m, 0, 0, 0}, period_s);
    EXPECT_EQ(follower.status(), PathFollower::Status::driving) << follower.reason();
    return follower.next_waypoint();
  };
  EXPECT_EQ(next_after({10, 0}, {30, -8}), 0u) << "ahead and beside";
  EXPECT_EQ(next_after({40, 0}, {5, 2}), 0u) << "behind";
  EXPECT_EQ(next_after({40, 0}, {53, 20}), 1u) << "past a corner";
  EXPECT_EQ(next_after({40, 0}, {20, 45}), 2u) << "far ahead";
}

// On the way out and back over the same line, it stays on its way out.
TEST(PathFollower, begins_again_on_the_same_way_of_a_line_driven_twice) {
  PathFollower follower({{100, 0, 0}, {0, 0, 0}}, {{0, 0}, 0, 0, 0}, {});
  follower.update({{60, 0}, 0, 1, 0}, period_s);
  follower.begin_again({{75, 1}, 0, 0, 0});
  follower.update({{75, 1}, 0, 0, 0}, period_s);
  EXPECT_EQ(follower.next_waypoint(), 0u);
  EXPECT_NEAR(follower.remaining_m(), 25 + 100, 1);
}

TEST(DrivingLine, rounds_a_gentle_corner_within_the_offset_and_stops_at_a_sharp_one) {
  DrivingLimits limits;
  limits.speed_mps = 2;
  const std::vector<DrivingPiece> line =
      driving_line({{0, 0}, {40, 0}, {80, 10}, {80, 50}}, limits);
  std::vector<Vec2> points{{0, 0}};
  int stops = 0;
  for (const DrivingPiece& leg : line) {
    points.push_back(leg.from_S_m + leg.length_m * leg.along_S);
    stops += leg.ends_in_stop;
  }
  EXPECT_NEAR(distance_to_line_m({40, 0}, points), fillet_offset_m, 0.015);
  EXPECT_EQ(stops, 2);  // the sharp corner and the end
  // Every leg can be driven: speeds change no faster than the acceleration allows.
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    EXPECT_LE(line[i].end_speed_mps, line[i + 1].speed_max_mps + 1e-12);
    EXPECT_NEAR(
        (line[i].from_S_m + line[i].length_m * line[i].along_S - line[i + 1].from_S_m).norm(), 0,
        1e-9);
  }
}

TEST(PathFollower, holds_a_line_across_a_slope) {
  const auto ground = test::moon(radians(15), radians(180));
  const Drive result = drive(*ground, {{60, 0}}, radians(90));
  EXPECT_EQ(result.status, PathFollower::Status::arrived) << result.reason;
  EXPECT_LT(result.worst_m, 0.5);
}

TEST(PathFollower, crabs_along_a_line_with_its_heading_kept) {
  const auto ground = test::moon(radians(5), radians(180));
  const Drive result = drive(*ground, {{20, 0}, {30, 20}}, radians(0), true);
  EXPECT_EQ(result.status, PathFollower::Status::arrived) << result.reason;
  EXPECT_LT(result.worst_m, 0.5);
  EXPECT_NEAR(result.yaw_rad, radians(90), 0.05);
}

TEST(PathFollower, begins_by_turning_when_the_line_lies_behind) {
  const auto ground = test::moon();
  const Drive result = drive(*ground, {{-30, 5}}, radians(90));
  EXPECT_EQ(result.status, PathFollower::Status::arrived) << result.reason;
  EXPECT_LT(result.worst_m, 0.5);
}

TEST(PathFollower, says_that_it_is_stuck_when_it_gets_nowhere) {
  FollowerLimits limits;
  const FollowerPose pose{Vec2::Zero(), 0, 0};
  PathFollower follower({{100, 0, 0}}, pose, limits);
  int periods = 0;
  while (follower.status() == PathFollower::Status::driving && periods < 10000) {
    follower.update(pose, period_s);
    ++periods;
  }
  EXPECT_EQ(follower.status(), PathFollower::Status::failed);
  EXPECT_NE(follower.reason().find("stuck"), std::string::npos);
  EXPECT_NEAR(periods * period_s, 60, 1);
}

TEST(PathFollower, says_when_the_brakes_do_not_hold) {
  FollowerPose pose{Vec2::Zero(), 0, 2};  // keeps sliding
  PathFollower follower({{0, 0, 0}}, pose, {});
  for (int i = 0; i < 400; ++i) follower.update(pose, period_s);
  EXPECT_EQ(follower.status(), PathFollower::Status::failed);
  EXPECT_NE(follower.reason().find("still sliding at 2.00 m/s"), std::string::npos);
}

// A block on the Moon that slides when it is commanded to slow down faster than the soil holds it.
struct Slide {
  double past_m = 0;     // beyond the end
  double worst_mps = 0;  // over the speed of its wheels
  double fastest_mps = 0;
};
Slide slid(double pitch_rad, double piece_m, bool is_crabbing = false) {
  FollowerLimits limits;
  limits.speed_mps = limits.level_speed_mps = 2.5;
  limits.acceleration_mps2 = 0.5;
  limits.gravity_mps2 = test::moon_g_mps2;
  limits.is_crabbing = is_crabbing;
  Path3 path;
  for (double x_m = piece_m; x_m < 60 + piece_m / 2; x_m += piece_m) path.push_back({x_m, 0, 0});
  // A crabbing rover goes along x as well, with its right side ahead.
  FollowerPose pose{Vec2::Zero(), is_crabbing ? radians(90) : 0};
  (is_crabbing ? pose.roll_rad : pose.pitch_rad) = is_crabbing ? -pitch_rad : pitch_rad;
  PathFollower follower(path, pose, limits);
  Slide result;
  const double grip_mps2 = test::moon_g_mps2 * (0.45 * std::cos(pitch_rad) + std::sin(pitch_rad));
  for (int i = 0; i < 3000 && follower.status() == PathFollower::Status::driving; ++i) {
    const DriveCommand command = follower.update(pose, period_s);
    const double wheels_mps =
        command.is_braking ? 0 : std::hypot(command.speed_mps, command.left_mps);
    const double slowest_mps = pose.speed_mps - grip_mps2 * period_s;
    if (!command.is_braking) {
      result.worst_mps = std::max(result.worst_mps, slowest_mps - wheels_mps);
    }
    pose.speed_mps = std::max(wheels_mps, slowest_mps);
    pose.p_S_m.x() += pose.speed_mps * period_s;
    result.fastest_mps = std::max(result.fastest_mps, pose.speed_mps);
  }
  result.past_m = pose.p_S_m.x() - 60;
  return result;
}

TEST(PathFollower, brakes_in_time_downhill_however_short_the_pieces_of_its_line_are) {
  EXPECT_EQ(slid(0, 60).fastest_mps, 2.5);
  for (const double piece_m : {60.0, 5.0, 0.5}) {
    for (const bool is_crabbing : {false, true}) {
      const Slide result = slid(radians(-20), piece_m, is_crabbing);
      EXPECT_LT(result.worst_mps, 0.1) << piece_m << is_crabbing;
      EXPECT_LT(std::abs(result.past_m), 0.1) << piece_m << is_crabbing;
      EXPECT_LT(result.fastest_mps, 1.8);
      EXPECT_GT(result.fastest_mps, 1.2);
    }
  }
}

TEST(PathFollower, has_patience_with_a_slow_turn) {
  FollowerLimits limits;
  limits.speed_mps = 0.02;
  FollowerPose pose{Vec2::Zero(), 3.1, 0};
  PathFollower follower({{100, 0, 0}}, pose, limits);
  for (int i = 0; i < 6000; ++i) {
    const DriveCommand command = follower.update(pose, period_s);
    pose.yaw_rad += std::clamp(command.yaw_rate_radps, -0.005, 0.005) * period_s;
  }
  EXPECT_EQ(follower.status(), PathFollower::Status::driving) << follower.reason();
}

TEST(PathFollower, a_line_that_ends_where_the_rover_stands_is_done_at_once) {
  const FollowerPose pose{Vec2(3, 4), 0, 0};
  PathFollower follower({{3, 4, 0}}, pose, {});
  EXPECT_TRUE(follower.update(pose, period_s).is_braking);
  EXPECT_EQ(follower.status(), PathFollower::Status::arrived);
}

// A rover as a point that moves along its heading, with a turning radius of at least 4 m, stepped
// by 0.1 s.
struct Car {
  FollowerPose pose;
  PathFollower follower;
  std::vector<double> nearest_m;  // to each waypoint

  void drive(const Path3& path, const FollowerPose& start) {
    FollowerLimits limits;
    limits.can_turn_on_spot = false;
    limits.radius_min_m = 4;
    limits.speed_mps = 2;
    pose = start;
    follower = PathFollower(path, pose, limits);
    nearest_m.assign(path.size(), 1e9);
    for (int i = 0; i < 6000 && follower.status() == PathFollower::Status::driving; ++i) {
      const DriveCommand command = follower.update(pose, period_s);
      pose.speed_mps = command.is_braking ? 0 : command.speed_mps;
      pose.yaw_rad += command.is_braking ? 0 : command.yaw_rate_radps * period_s;
      pose.p_S_m +=
          period_s * pose.speed_mps * Vec2(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
      for (std::size_t k = 0; k < path.size(); ++k) {
        nearest_m[k] = std::min(nearest_m[k], (path[k].head<2>() - pose.p_S_m).norm());
      }
    }
  }
};

TEST(PathFollower, passes_a_waypoint_that_the_rover_stands_on) {
  Car car;
  car.drive({{-0.4, 0.3, 0}, {0.2, -0.9, 0}, {30, 0, 0}}, {Vec2::Zero(), 0, 0});
  EXPECT_EQ(car.follower.status(), PathFollower::Status::arrived) << car.follower.reason();
  EXPECT_LT(std::abs(car.pose.p_S_m.y()), 0.1);
  const FollowerPose on_goal{Vec2(0.5, 0), 0, 0};
  PathFollower there({{0, 0, 0}}, on_goal, {});
  there.update(on_goal, period_s);
  EXPECT_EQ(there.status(), PathFollower::Status::arrived);
}

TEST(PathFollower, a_rover_that_cannot_turn_on_the_spot_takes_every_corner) {
  const std::vector<Path3> paths{
      {{-30, 0, 0}},                           // the rover heads the other way
      {{30, 0, 0}, {0, 0, 0}},                 // there and back
      {{2, 0, 0}, {2, 30, 0}},                 // a corner without room for an arc
      {{30, 0, 0}, {28, 20, 0}, {40, 30, 0}},  // arcs of the least radius
      {{30, 0, 0}, {30, 3, 0}, {0, 3, 0}},     // sides shorter than a turn
      {{30, 0, 0}, {15, 1, 0}, {30, 2, 0}},    // back and forth
  };
  for (const Path3& path : paths) {
    Car car;
    car.drive(path, {Vec2::Zero(), 0, 0});
    EXPECT_EQ(car.follower.status(), PathFollower::Status::arrived) << car.follower.reason();
    // An arc of 4 m radius passes a corner of 94 degrees by 1.9 m; two corners within the width of
    // a turn are passed by less than its radius.
    for (const double nearest_m : car.nearest_m) EXPECT_LT(nearest_m, 4);
  }
}

}  // namespace
}  // namespace lsos
