// ATHLETE on its limbs: level decks, shared loads, standing on slopes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "lua/host/mission_reader.h"
#include "mission/model/site.h"
#include "mission/routes/follower_limits.h"
#include "physics/drive.h"
#include "planet/ellipsoid.h"
#include "vehicle/follower_pose.h"

namespace lsos {
namespace {

struct PostureDrive {
  std::string failure;
  std::vector<double> tilts_rad;    // of the chassis from level, at each exchange
  std::vector<double> load_shares;  // of each wheel, in its share at rest
  std::vector<double> slopes_rad;
  double duration_s = 0;
};

double tilt_rad(const VehicleReport& report) {
  return std::acos(std::cos(report.pitch_rad) * std::cos(report.roll_rad));
}

PostureDrive drive_straight(const VehicleConfig& config, const Ground& ground, const Geodetic& from,
                            double heading_rad, double length_m) {
  PostureDrive result;
  Vehicle vehicle(config, ground);
  result.failure = vehicle.place(from, heading_rad);
  if (!result.failure.empty()) return result;
  const SiteFrame& site = ground.site();
  VehicleReport report = vehicle.report();
  const FollowerLimits limits =
      limits_of(config, config.cruise_speed_mps, site.gravity_S_mps2(Vec3::Zero()).norm());
  PathFollower follower({report.p_S_m + length_m * site.horizontal_S(heading_rad, report.p_S_m)},
                        follower_pose(report), limits);
  const double share_n =
      config.mass_kg() * limits.gravity_mps2 / static_cast<double>(config.limbs.size());
  while (follower.status() == PathFollower::Status::driving && result.duration_s < 3600) {
    vehicle.command(follower.update(follower_pose(report), seconds(exchange_period)));
    vehicle.advance(exchange_period);
    report = vehicle.report();
    if (!report.is_finite) {
      result.failure = vehicle.fault();
      return result;
    }
    result.duration_s += seconds(exchange_period);
    result.tilts_rad.push_back(tilt_rad(report));
    result.slopes_rad.push_back(report.slope_rad);
    for (std::size_t i = 0; i < config.limbs.size(); ++i) {
      result.load_shares.push_back(vehicle.wheel_load_n(i) / share_n);
    }
  }
  if (follower.status() != PathFollower::Status::arrived) result.failure = follower.reason();
  return result;
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

template <class Is>
double share_of(const std::vector<double>& values, const Is& is) {
  return static_cast<double>(std::ranges::count_if(values, is)) /
         static_cast<double>(values.size());
}

// The start has slopes of 10 to 15 degrees ahead, in craters as large as the rover.
const Geodetic start{radians(30), radians(-89.3), 0};

std::unique_ptr<Ground> pole() {
  return ground_at(test::shipped_terrain("LunarSouthPole"), *find_body("Moon"), start, 7);
}

TEST(Posture, chassis_stays_level_and_wheels_share_the_load_over_craters) {
  const auto ground = pole();
  const VehicleConfig config = test::rover_on("ATHLETE", *ground, "Moon", "Drive");
  const PostureDrive drive = drive_straight(config, *ground, start, radians(60), 500);
  ASSERT_EQ(drive.failure, "");
  ASSERT_GT(degrees(quantile(drive.slopes_rad, 1)), 10);
  EXPECT_LT(degrees(quantile(drive.tilts_rad, 0.95)), 2);
  EXPECT_LT(degrees(quantile(drive.tilts_rad, 1)), 4);
  const auto is_shared = [](double share) { return share >= 0.4 && share <= 1.8; };
  EXPECT_GE(share_of(drive.load_shares, is_shared), 0.95);
}

TEST(Posture, without_levelling_the_same_ground_tilts_the_chassis) {
  const auto ground = pole();
  const VehicleConfig config = test::rover_on("ATHLETE", *ground, "Moon", "Passive");
  const PostureDrive drive = drive_straight(config, *ground, start, radians(60), 100);
  ASSERT_EQ(drive.failure, "");
  EXPECT_GT(degrees(quantile(drive.tilts_rad, 0.95)), 4);
}

TEST(Posture, without_posture_control_some_wheels_carry_nothing) {
  const auto ground = pole();
  VehicleConfig config = test::rover_on("ATHLETE", *ground, "Moon");
  config.posture.reset();
  const PostureDrive drive = drive_straight(config, *ground, start, radians(60), 100);
  ASSERT_EQ(drive.failure, "");
  const auto is_shared = [](double share) { return share >= 0.4 && share <= 1.8; };
  EXPECT_LT(share_of(drive.load_shares, is_shared), 0.8);
}

// Wheels turn about the ankles, so that it moves in any direction and on the spot.
TEST(Posture, crabs_and_turns_on_the_spot) {
  const auto ground =
      test::ground({.planet = "Moon", .surface = PlaneSurface{}, .soil = "ApolloNominal"});
  Vehicle vehicle(test::rover_on("ATHLETE", *ground, "Moon"), *ground);
  ASSERT_EQ(vehicle.place(ground->site().origin(), 0), "");
  const auto drive = [&](const DriveCommand& command, int periods) {
    for (int i = 0; i < periods; ++i) {
      vehicle.command(command);
      vehicle.advance(exchange_period);
    }
  };
  drive({.is_braking = false, .left_mps = 0.3}, 400);
  VehicleReport report = vehicle.report();
  EXPECT_NEAR(report.p_S_m.x(), -40 * 0.3, 2);  // heading north, left is west
  EXPECT_NEAR(report.p_S_m.y(), 0, 0.5);
  EXPECT_NEAR(std::remainder(report.heading_rad, 2 * std::numbers::pi), 0, 0.05);
  drive({}, 50);
  const Vec3 before_m = vehicle.report().p_S_m;
  drive({.yaw_rate_radps = 0.08, .is_braking = false}, 300);
  report = vehicle.report();
  EXPECT_LT((report.p_S_m - before_m).norm(), 0.3);
  EXPECT_NEAR(std::remainder(report.heading_rad, 2 * std::numbers::pi), -30 * 0.08, 0.5);
}

}  // namespace
}  // namespace lsos
