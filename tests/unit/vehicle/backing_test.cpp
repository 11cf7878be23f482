// Lines on which a rover backs up: it stops where the gear changes and drives the other way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/segment.h"
#include "base/units.h"
#include "driving/driving_line.h"
#include "test_rover.h"
#include "test_site.h"
#include "vehicle/path_follower.h"
#include "vehicle/vehicle.h"

namespace lsos {
namespace {

using testing::ElementsAre;

using test::period_s;

// Points of an arc from a pose of travel, which they end in.
void add_arc(std::vector<Vec2>& line, double& travel_rad, double radius_m, double turn_rad) {
  constexpr int pieces = 8;
  const double side = turn_rad > 0 ? 1 : -1;
  const Vec2 from = line.back();
  const Vec2 center = from + side * radius_m * Vec2(-std::sin(travel_rad), std::cos(travel_rad));
  for (int k = 1; k <= pieces; ++k) {
    line.push_back(center + Eigen::Rotation2Dd(turn_rad * k / pieces) * (from - center));
  }
  travel_rad += turn_rad;
}

// A turn in three strokes, each of 60 degrees, on arcs of `radius_m`, and 20 m on: from the origin,
// heading east, to heading west.
struct ThreeStrokes {
  explicit ThreeStrokes(double radius_m) {
    double travel_rad = 0;
    add_arc(line, travel_rad, radius_m, radians(60));
    gear_changes.push_back(line.size() - 1);
    travel_rad += radians(180);
    add_arc(line, travel_rad, radius_m, radians(60));
    gear_changes.push_back(line.size() - 1);
    travel_rad += radians(180);
    add_arc(line, travel_rad, radius_m, radians(60));
    line.push_back(line.back() + 20 * Vec2(std::cos(travel_rad), std::sin(travel_rad)));
  }
  Path3 path() const {
    Path3 points;
    for (const Vec2& p : line) points.emplace_back(p.x(), p.y(), 0);
    return points;
  }
  double off_m(const Vec2& p) const {
    double least_m = 1e9;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      least_m = std::min(least_m, point_distance_m(line[k], line[k + 1], p));
    }
    return least_m;
  }

  std::vector<Vec2> line{Vec2::Zero()};
  std::vector<std::size_t> gear_changes;
};

TEST(DrivingLine, stops_where_the_gear_changes) {
  DrivingLimits limits;
  limits.can_turn_on_spot = false;
  const std::vector<DrivingPiece> line =
      driving_line({{0, 0}, {10, 0}, {4, 0}, {20, 0}}, limits, {1, 2});
  ASSERT_EQ(line.size(), 3u);
  std::vector<bool> backward, stops;
  for (const DrivingPiece& piece : line) {
    backward.push_back(piece.is_backward);
    stops.push_back(piece.ends_in_stop);
    EXPECT_EQ(piece.end_speed_mps, 0);
  }
  EXPECT_THAT(backward, ElementsAre(false, true, false));
  EXPECT_THAT(stops, ElementsAre(true, true, true));
  EXPECT_EQ(line[1].begin_m, 10);
  EXPECT_EQ(line[2].begin_m, 16);
  EXPECT_EQ(line[1].along_S, Vec2(-1, 0));
}

TEST(DrivingLine, may_begin_backwards) {
  const std::vector<DrivingPiece> line = driving_line({{0, 0}, {-5, 0}, {3, 0}}, {}, {0, 1});
  ASSERT_EQ(line.size(), 2u);
  EXPECT_TRUE(line[0].is_backward);
  EXPECT_FALSE(line[1].is_backward);
}

// The rover is placed, not driven.
TEST(PathFollower, commands_a_rover_backwards) {
  FollowerLimits limits;
  limits.can_turn_on_spot = false;
  // A point that is nearer than the arrival radius is not passed where the gear changes.
  PathFollower follower({{0, 0, 0}, {-0.8, 0, 0}, {20, 0, 0}}, {{0, 0}, 0, 0, 0}, limits, {0, 1});
  const auto after_steering = [&](const FollowerPose& at_rest) {
    for (int k = 0; k < 20; ++k) follower.update(at_rest, period_s);
    return follower.update(at_rest, period_s);
  };
  const DriveCommand first = follower.update({{0, 0}, 0, 0, 0}, period_s);
  EXPECT_NEAR(first.speed_mps, 0, 0.01) << "it steers first";
  const DriveCommand back = after_steering({{0, 0}, 0, 0, 0});
  EXPECT_LT(back.speed_mps, -0.1);
  EXPECT_NEAR(back.yaw_rate_radps, 0, 1e-9);
  EXPECT_EQ(follower.next_waypoint(), 1u);
  // Left of the line it turns its back to the right, so that its heading turns to the left.
  const DriveCommand aside = follower.update({{-0.2, 0.1}, 0, 0.3, 0}, period_s);
  EXPECT_LT(aside.speed_mps, -0.1);
  EXPECT_GT(aside.yaw_rate_radps, 0);
  EXPECT_EQ(follower.update({{-0.8, 0}, 0, 0.3, 0}, period_s).speed_mps, 0) << "it stops first";
  const DriveCommand on = after_steering({{-0.8, 0}, 0, 0, 0});
  EXPECT_GT(on.speed_mps, 0.1);
  EXPECT_NEAR(follower.remaining_m(), 20.8, 0.01);
  EXPECT_EQ(follower.next_waypoint(), 2u);
}

// Before a long straight piece the wheels stay straight.
TEST(PathFollower, steers_for_the_piece_that_it_stands_on) {
  FollowerLimits limits;
  limits.can_turn_on_spot = false;
  std::vector<Vec2> line{{0, 0}, {-8, 0}};
  double travel_rad = std::numbers::pi;
  add_arc(line, travel_rad, 6, radians(60));
  Path3 path;
  for (const Vec2& p : line) path.emplace_back(p.x(), p.y(), 0);
  PathFollower straight(path, {{0, 0}, 0, 0, 0}, limits, {0});
  for (int k = 0; k < 15; ++k) {
    const DriveCommand command = straight.update({{0, 0}, 0, 0, 0}, period_s);
    EXPECT_LT(command.speed_mps, 0);
    EXPECT_EQ(command.yaw_rate_radps, 0) << k;
  }
  path.erase(path.begin());
  const Vec2 begin(-8, 0);
  PathFollower bent(path, {begin, 0, 0, 0}, limits, {0});
  DriveCommand command;
  for (int k = 0; k < 15; ++k) command = bent.update({begin, 0, 0, 0}, period_s);
  EXPECT_NEAR(command.yaw_rate_radps / std::abs(command.speed_mps), 1 / 6.0, 0.01);
}

// East 20 m, back 6 m, and on to the north-east.
const Path3 there_and_back{{20, 0, 0}, {14, 0, 0}, {40, 5, 0}};
const std::vector<std::size_t> its_changes{0, 1};

TEST(PathFollower, begins_again_in_the_gear_of_the_piece_that_is_nearest) {
  FollowerLimits limits;
  limits.can_turn_on_spot = false;
  struct Put {
    Vec2 from_S_m, to_S_m;  // where it was, and where it is put
    bool is_backward;
    std::size_t next;
  };
  for (const Put& put : {Put{{5, 0}, {8, 1}, false, 0}, Put{{19, 0}, {30, 3}, false, 2}}) {
    PathFollower follower(there_and_back, {{0, 0}, 0, 0, 0}, limits, its_changes);
    follower.update({put.from_S_m, 0, 1, 0}, period_s);
    follower.begin_again({put.to_S_m, 0, 0, 0});
    EXPECT_EQ(follower.is_backward(), put.is_backward) << put.to_S_m.transpose();
    EXPECT_EQ(follower.next_waypoint(), put.next) << put.to_S_m.transpose();
  }
  // While it backs up it goes on backwards.
  PathFollower follower(there_and_back, {{0, 0}, 0, 0, 0}, limits, its_changes);
  follower.update({{20, 0}, 0, 0, 0}, period_s);
  ASSERT_TRUE(follower.is_backward());
  for (int k = 0; k < 30; ++k) follower.update({{17, 0}, 0, 0, 0}, period_s);
  follower.begin_again({{16, 0.5}, 0, 0, 0});
  EXPECT_TRUE(follower.is_backward());
  EXPECT_EQ(follower.next_waypoint(), 1u);
  EXPECT_NEAR(follower.remaining_m(), 2.06 + std::hypot(26, 5), 0.01);
}

TEST(PathFollower, that_is_saved_while_it_changes_its_gear_goes_on_alike) {
  FollowerLimits limits;
  limits.can_turn_on_spot = false;
  PathFollower follower(there_and_back, {{0, 0}, 0, 0, 0}, limits, its_changes);
  for (int k = 0; k < 4; ++k) follower.update({{20, 0}, 0, 0, 0}, period_s);
  Archive writer = Archive::writer();
  follower.archive(writer);
  PathFollower again;
  Archive reader = Archive::reader(writer.bytes());
  again.archive(reader);
  for (int k = 0; k < 30; ++k) {
    const FollowerPose pose{{20 - 0.01 * k, 0.02}, 0.01, 0.1, 0};
    const DriveCommand one = follower.update(pose, period_s), two = again.update(pose, period_s);
    EXPECT_EQ(one.speed_mps, two.speed_mps) << k;
    EXPECT_EQ(one.yaw_rate_radps, two.yaw_rate_radps) << k;
  }
  EXPECT_TRUE(again.is_backward());
}

TEST(PathFollower, turns_round_in_three_strokes) {
  const auto ground = test::moon();
  FollowerLimits limits;
  limits.speed_mps = 2;
  limits.acceleration_mps2 = 0.3;
  limits.can_turn_on_spot = false;
  limits.radius_min_m = 4;
  const ThreeStrokes strokes(1.1 * limits.radius_min_m);
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(ground->site().origin(), radians(90)), "");
  const auto pose = [&] {
    const VehicleReport report = vehicle.report();
    const Vec2 left_S(-std::sin(report.yaw_rad), std::cos(report.yaw_rad));
    return FollowerPose{report.p_S_m.head<2>(), report.yaw_rad, report.speed_mps,
                        left_S.dot(report.v_S_mps.head<2>())};
  };
  PathFollower follower(strokes.path(), pose(), limits, strokes.gear_changes);
  double worst_m = 0, backwards_m = 0;
  for (int i = 0; i < 3000 && follower.status() == PathFollower::Status::driving; ++i) {
    const Vec2 before_m = pose().p_S_m;
    vehicle.command(follower.update(pose(), period_s));
    vehicle.advance(exchange_period);
    worst_m = std::max(worst_m, strokes.off_m(pose().p_S_m));
    if (follower.is_backward()) backwards_m += (pose().p_S_m - before_m).norm();
  }
  std::printf("greatest cross-track error %.2f m, %.2f m backwards\n", worst_m, backwards_m);
  EXPECT_EQ(follower.status(), PathFollower::Status::arrived) << follower.reason();
  EXPECT_LT(worst_m, 0.2);
  EXPECT_NEAR(backwards_m, 1.1 * limits.radius_min_m * radians(60), 0.2);
  EXPECT_NEAR(std::abs(std::remainder(pose().yaw_rad, 2 * std::numbers::pi)), std::numbers::pi,
              0.05);
  EXPECT_LT((pose().p_S_m - strokes.line.back()).norm(), 0.3);
}

}  // namespace
}  // namespace lsos
