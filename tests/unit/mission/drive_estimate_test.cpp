// What a drive along a line is expected to take.
#include "mission/routes/drive_estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "mission/model/site.h"
#include "mission/routes/drive_cost_model.h"
#include "mission/routes/follower_limits.h"
#include "unit/vehicle/test_rover.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

constexpr double deg = std::numbers::pi / 180;

// A slope that falls to the east, and a rover on it.
class DrawnDrive : public ::testing::Test {
 protected:
  static std::unique_ptr<Ground> slope() {
    TerrainSpec spec;
    spec.name = "Test";
    spec.layers = {PlaneSurface{0, 6 * deg, 90 * deg}};
    spec.soil = soil();
    return ground_at(spec, *find_body("Moon"), {0.1, 0.2, 0}, 0);
  }
  DriveEstimate drive(const Path3& path_S_m, double yaw_rad = 0, FollowSettings settings = {}) {
    return estimate_drawn(*ground, cost, limits_of(vehicle, cost.speed_mps, cost.gravity_mps2),
                          {0, 0, 0}, yaw_rad, path_S_m, settings);
  }

  std::unique_ptr<Ground> ground = slope();
  VehicleConfig vehicle = rover(1.6);
  DriveCost cost = drive_cost(vehicle, ground->soils(), 1.62, vehicle.cruise_speed_mps);
};

TEST_F(DrawnDrive, takes_the_time_of_its_length_and_of_stopping) {
  const DriveMark end = drive({{300, 0, 0}}).marks.back();
  EXPECT_NEAR(end.along_m, 300, 1e-6);
  EXPECT_NEAR(end.driven_m, 300 / std::cos(6 * deg), 0.1);
  EXPECT_GT(end.time_s, 300 / cost.speed_mps);
  EXPECT_LT(end.time_s, 300 / cost.speed_mps + 2 * cost.stop_s + 20);
}

TEST_F(DrawnDrive, uses_more_uphill_than_downhill) {
  const DriveMark down = drive({{300, 0, 0}}).marks.back();
  const DriveMark up = drive({{-300, 0, 0}}, std::numbers::pi).marks.back();
  const double climbed_j = vehicle.mass_kg() * 1.62 * 300 * std::tan(6 * deg);
  EXPECT_GT(up.energy_j, climbed_j);
  EXPECT_GT(up.energy_j, 2 * down.energy_j);
}

// Back the way it came: an arc of 270 degrees and one of 90, which end two radii along the line.
TEST_F(DrawnDrive, swings_round_where_it_cannot_turn_on_the_spot) {
  vehicle.can_turn_on_spot = cost.can_turn_on_spot = false;
  vehicle.turning_radius_min_m = 3;
  const DriveMark ahead = drive({{0, 300, 0}}, 90 * deg).marks.back();
  const DriveMark back = drive({{0, 300, 0}}, -90 * deg).marks.back();
  const double detour_m = (2 * std::numbers::pi - 2) * 3;
  EXPECT_NEAR(back.driven_m - ahead.driven_m, detour_m, 0.01);
  EXPECT_NEAR(back.along_m, ahead.along_m, 1e-6);
  const double takes_s = detour_m / vehicle.cruise_speed_mps;
  EXPECT_NEAR(back.time_s - ahead.time_s, takes_s, 0.01 * takes_s);
  EXPECT_GT(back.energy_j, ahead.energy_j);
  const DriveMark aside = drive({{0, 300, 0}}, 0).marks.back();
  // Arcs of 150 and of 60 degrees, which end (1 + sqrt(3)) radii along it.
  EXPECT_NEAR(aside.driven_m - ahead.driven_m, (210 * deg - 1 - std::numbers::sqrt3) * 3, 0.01);
}

TEST_F(DrawnDrive, turns_first_and_at_sharp_corners) {
  const double straight_s = drive({{100, 0, 0}, {200, 0, 0}}).marks.back().time_s;
  const double there_and_back_s = drive({{100, 0, 0}, {0, 0, 0}}).marks.back().time_s;
  const double turned_s = drive({{200, 0, 0}}, std::numbers::pi).marks.back().time_s;
  EXPECT_NEAR(turned_s - straight_s, cost.steer_s + cost.turn_sprad * std::numbers::pi, 1);
  EXPECT_GT(there_and_back_s, turned_s);
}

TEST_F(DrawnDrive, has_marks_no_farther_apart_than_they_may_be) {
  const DriveEstimate estimate = drive({{1000, 0, 0}});
  EXPECT_GE(estimate.marks.size(), 5U);
  for (std::size_t k = 1; k < estimate.marks.size(); ++k) {
    EXPECT_LE(estimate.marks[k].along_m - estimate.marks[k - 1].along_m, mark_spacing_m + 1e-6);
  }
}

TEST_F(DrawnDrive, ends_where_its_wheels_do_not_climb) {
  for (SoilDrive& soil : cost.soils) {
    while (soil.last_rad() > 5 * deg) soil.by_slope.pop_back();
  }
  const DriveEstimate estimate = drive({{-300, 0, 0}}, std::numbers::pi);
  EXPECT_THAT(estimate.failure, HasSubstr("stuck: the ground rises by 6 deg"));
  EXPECT_TRUE(estimate.is_blocked);
  EXPECT_LT(estimate.marks.back().along_m, 5);
  EXPECT_EQ(drive({{300, 0, 0}}).failure, "");
}

TEST_F(DrawnDrive, to_where_the_rover_stands_takes_nothing) {
  const DriveEstimate estimate = drive({{0.2, 0, 0}});
  EXPECT_EQ(estimate.marks.size(), 1U);
  EXPECT_EQ(estimate.line_S_m.size(), 1U);
}

}  // namespace
}  // namespace lsos::test
