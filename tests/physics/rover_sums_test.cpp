// Energy balances of shipped rovers, and their known abilities.
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "physics/drive.h"

namespace lsos::test {
namespace {

// Slopes up to some 15 degrees: shallow craters on a plane that rises by 3 degrees to the north.
const GroundAt hills{"Moon", PlaneSurface{0, radians(3), radians(180)}, "ApolloNominal",
                     Detail{.craters = CraterPopulation{.diameter_min_m = 10,
                                                        .diameter_max_m = 80,
                                                        .age_gyr = {},
                                                        .exponent = 2,
                                                        .density_pm2 = 6e-4,
                                                        .depth_to_diameter = 0.06,
                                                        .degradation = {}},
                            .rocks = {},
                            .roughness = {}}};
const std::vector<Vec2> kilometre{{150, 250}, {400, 300}, {500, 550}, {700, 700}};

class OverHills : public testing::TestWithParam<const char*> {};

TEST_P(OverHills, motors_do_what_energy_changes_and_losses_say) {
  const auto hilly = ground(hills);
  const DriveResult result = drive(rover_on(GetParam(), *hilly, "Moon"), *hilly, kilometre, 2);
  ASSERT_EQ(result.failure, "");
  ASSERT_GT(result.distance_m, 1000);
  const WorkDone& work = result.work;
  EXPECT_GT(work.motors_j, 0);
  EXPECT_LT(work.soil_j, 0);
  EXPECT_LT(work.suspension_j, 0);
  EXPECT_NEAR(work.sum_j(), result.energy_change_j, 0.01 * work.motors_j);
  RecordProperty("motors_j", std::to_string(work.motors_j));
  RecordProperty("off_j", std::to_string(work.sum_j() - result.energy_change_j));
}

TEST_P(OverHills, half_the_step_ends_at_the_same_place_with_the_same_energy) {
  const auto hilly = ground(hills);
  const DriveResult whole = drive(rover_on(GetParam(), *hilly, "Moon"), *hilly, kilometre, 2);
  const DriveResult half =
      drive(rover_on(GetParam(), *hilly, "Moon", "", 0.5), *hilly, kilometre, 2);
  ASSERT_EQ(whole.failure + half.failure, "");
  EXPECT_LT((whole.end.p_S_m - half.end.p_S_m).norm(), 0.2);
  EXPECT_NEAR(whole.drive_j, half.drive_j, 0.01 * half.drive_j);
}

INSTANTIATE_TEST_SUITE_P(Rovers, OverHills, testing::Values("SEV", "LRV"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(Mer, half_the_step_and_the_sums_over_hills) {
  GroundAt martian{"Mars", hills.surface, "MMS", hills.detail};
  const auto hilly = ground(martian);
  const std::vector<Vec2> path{{8, 12}, {30, 25}};
  const DriveResult whole = drive(rover_on("MER", *hilly, "Mars"), *hilly, path, 0.05);
  const DriveResult half = drive(rover_on("MER", *hilly, "Mars", "", 0.5), *hilly, path, 0.05);
  ASSERT_EQ(whole.failure + half.failure, "");
  EXPECT_LT((whole.end.p_S_m - half.end.p_S_m).norm(), 0.2);
  EXPECT_NEAR(whole.drive_j, half.drive_j, 0.01 * half.drive_j);
  EXPECT_NEAR(whole.work.sum_j(), whole.energy_change_j, 0.01 * whole.work.motors_j);
}

TEST(Lrv, needs_35_to_90_watt_hours_a_kilometre_on_level_regolith) {
  const auto level = ground({"Moon", PlaneSurface{}, "ApolloNominal"});
  const DriveResult result = drive(rover_on("LRV", *level, "Moon"), *level, {{0, 1000}}, 2.8);
  ASSERT_EQ(result.failure, "");
  const double wh_pkm = result.drive_j / 3600 / (result.distance_m / 1000);
  RecordProperty("wh_pkm", std::to_string(wh_pkm));
  EXPECT_GT(wh_pkm, 35);
  EXPECT_LT(wh_pkm, 90);
}

// A climb straight up a plane from rest until the motion is steady.
struct Climb {
  bool stands = false;
  double slip = 1, speed_mps = 0;  // slip of the wheels; speed uphill
};
Climb climb(const char* rover, const char* planet, const char* soil, double slope_rad,
            double speed_mps, double duration_s) {
  const auto slope = ground({planet, PlaneSurface{0, slope_rad, radians(180)}, soil});
  const VehicleConfig config = rover_on(rover, *slope, planet);
  Vehicle vehicle(config, *slope);
  if (!vehicle.place(start, 0).empty()) return {};  // it slides down at once
  vehicle.command({speed_mps, 0, false});
  for (double t = 0; t < duration_s; t += 0.1) vehicle.advance(exchange_period);
  const VehicleReport report = vehicle.report();
  return {true, report.slip, report.v_S_mps.y() / std::cos(slope_rad)};
}

TEST(Lrv, climbs_20_degrees_but_not_35) {
  EXPECT_GT(climb("LRV", "Moon", "ApolloNominal", radians(20), 1, 60).speed_mps, 0.3);
  EXPECT_LE(climb("LRV", "Moon", "ApolloNominal", radians(35), 1, 60).speed_mps, 0.01);
}

// Measured: about 0.2 at 10 degrees, 0.4 to 0.6 at 15, near 1 at 20 (Lindemann and Voorhees 2005).
// Computed: 0.23 at 10; the model stops at 15 already.
TEST(Mer, slips_on_loose_dry_sand_as_in_tilt_bed_tests) {
  std::string table;
  double slip[6];
  for (int i = 0; i < 6; ++i) {
    const Climb up = climb("MER", "Mars", "DrySandLoose", radians(5.0 * i), 0.04, 120);
    EXPECT_TRUE(up.stands) << 5 * i << " deg";
    slip[i] = up.slip;
    table += std::to_string(5 * i) + " deg: " + std::to_string(slip[i]) + "\n";
  }
  SCOPED_TRACE(table);
  RecordProperty("slip_by_slope", table);
  for (int i = 1; i < 6; ++i) EXPECT_GE(slip[i], slip[i - 1] - 1e-3);
  EXPECT_LT(slip[2], 0.25);
  EXPECT_GT(slip[4], 0.8);
  EXPECT_GT(slip[5], 0.8);
}

// Curiosity climbed 23 degrees of sand and rock; loose soil so steep stops the model.
TEST(Msl, climbs_23_degrees_of_firm_ground_but_not_of_simulant) {
  EXPECT_GT(climb("MSL", "Mars", "Hardpan", radians(23), 0.03, 60).speed_mps, 0.02);
  EXPECT_GT(climb("MSL", "Mars", "Rock", radians(23), 0.03, 60).speed_mps, 0.02);
  EXPECT_LE(climb("MSL", "Mars", "MMS", radians(23), 0.03, 60).speed_mps, 0.01);
}

TEST(Viper, climbs_15_degrees_but_not_25) {
  EXPECT_GT(climb("VIPER", "Moon", "ApolloNominal", radians(15), 0.1, 60).speed_mps, 0.05);
  EXPECT_LE(climb("VIPER", "Moon", "ApolloNominal", radians(25), 0.1, 60).speed_mps, 0.01);
}

// The simulant of its wheel tests is cohesive; nominal regolith lets it slip by two thirds.
TEST(Rashid, climbs_20_degrees) {
  EXPECT_GT(climb("Rashid", "Moon", "Hurrell2025_FJS1", radians(20), 0.05, 60).speed_mps, 0.04);
  EXPECT_GT(climb("Rashid", "Moon", "ApolloNominal", radians(20), 0.05, 60).speed_mps, 0.01);
}

struct Follower {
  const char *rover, *planet, *soil;
  double speed_mps;
};
class Following : public testing::TestWithParam<Follower> {};

// Two gentle corners, and a sharp one for rovers that turn on the spot.
TEST_P(Following, stays_on_its_line_on_the_level_and_across_15_degrees) {
  const auto& [rover, planet, soil, speed_mps] = GetParam();
  for (const double slope_deg : {0.0, 15.0}) {
    const auto slope = ground({planet, PlaneSurface{0, radians(slope_deg), radians(180)}, soil});
    const VehicleConfig config = rover_on(rover, *slope, planet);
    std::vector<Vec2> line{{15, 0}, {30, 1}};
    if (slope_deg == 0) line = {{12, 0}, {20, 4}, {26, 4}};
    if (slope_deg == 0 && config.can_turn_on_spot) line.push_back({26, 14});
    const DriveResult result = drive(config, *slope, line, speed_mps);
    EXPECT_EQ(result.failure, "") << slope_deg;
    EXPECT_LT(result.worst_m, slope_deg == 0 ? 0.3 : 1.0) << slope_deg;
    EXPECT_LT((result.end.p_S_m.head<2>() - line.back()).norm(), 1) << slope_deg;
    RecordProperty(slope_deg == 0 ? "level_m" : "across_m", std::to_string(result.worst_m));
  }
}

INSTANTIATE_TEST_SUITE_P(Rovers, Following,
                         testing::Values(Follower{"SEV", "Moon", "ApolloNominal", 1.5},
                                         Follower{"LRV", "Moon", "ApolloNominal", 1.5},
                                         Follower{"MER", "Mars", "MMS", 0.04},
                                         Follower{"MSL", "Mars", "MMS", 0.035},
                                         Follower{"VIPER", "Moon", "ApolloNominal", 0.15},
                                         Follower{"Rashid", "Moon", "ApolloNominal", 0.07},
                                         Follower{"Husky", "Earth", "DrySand", 0.6}),
                         [](const auto& tested) { return std::string(tested.param.rover); });

class Parked : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Parked, on_20_degrees_does_not_move_in_two_hours_of_steps) {
  const auto [rover, planet] = GetParam();
  const auto slope = ground({planet, PlaneSurface{0, radians(20), radians(180)}, "ApolloNominal"});
  Vehicle vehicle(rover_on(rover, *slope, planet), *slope);
  ASSERT_EQ(vehicle.place(start, radians(30)), "");
  const auto run = [&](double duration_s) {
    for (double t = 0; t < duration_s; t += 0.1) vehicle.advance(exchange_period);
    return vehicle.report().p_S_m;
  };
  const Vec3 after_10_minutes_S_m = run(600);
  const Vec3 after_2_hours_S_m = run(6600);
  EXPECT_LT((after_2_hours_S_m - after_10_minutes_S_m).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Rovers, Parked,
                         testing::Values(std::pair("SEV", "Moon"), std::pair("LRV", "Moon"),
                                         std::pair("MER", "Mars"), std::pair("MSL", "Mars"),
                                         std::pair("VIPER", "Moon"), std::pair("Rashid", "Moon"),
                                         std::pair("ATHLETE", "Moon"), std::pair("Husky", "Earth")),
                         [](const auto& tested) { return std::string(tested.param.first); });

}  // namespace
}  // namespace lsos::test
