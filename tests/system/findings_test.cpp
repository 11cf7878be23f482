// Causes that end a drive: high-centring, rolling over, being stuck, another rover on the path;
// each gives a reason in the event and a row in `notes`. Standing on a slope for a week ends
// nothing.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "system/moon_ground.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

TEST(Findings, a_ridge_under_the_chassis_ends_the_drive) {
  // The crest is 0.5 m above a chord of the LRV's wheelbase, the chassis only 0.36 m above its
  // wheels.
  const TempFolder folder;
  write_raster(folder, "ridge", 100,
               [](double x_m, double) { return std::max(0.0, 0.9 - std::abs(x_m) * 0.9 / 1.9); });
  write_terrain(folder, "Ridge", "lsos.raster { file = 'ridge.asc' }", "'Rock'");
  const RunResult result =
      run_plan(folder, {on("Ridge"), rover("LRV", "A", place(-10, 0)),
                        event("Route", "A", 1, {{"Speed", "0.5"}}, point(place(10, 0)))});
  EXPECT_EQ(result.outcome.exit_code, 1);
  EXPECT_EQ(result.event("status"), "failed");
  EXPECT_THAT(result.event("reason"), HasSubstr("high-centred: its chassis touches the ground"));
  EXPECT_EQ(query(result.log, "select count(*) from notes where name = 'high_centred'"), "1");
}

TEST(Findings, a_bank_that_steepens_rolls_the_rover_over) {
  const TempFolder folder;
  write_raster(folder, "bank", 200, [](double x_m, double y_m) {
    const double bank_rad = std::min(1.2, std::max(0.0, x_m + 20) * 0.022);
    return y_m * std::tan(bank_rad);
  });
  write_terrain(folder, "Bank", "lsos.raster { file = 'bank.asc' }",
                "lsos.soil { is_rigid = true, cohesion_pa = 0, friction_rad = 1.25, "
                "density_kgpm3 = 2900, shear_modulus_x_m = 0.002 }");
  const RunResult result =
      run_plan(folder, {on("Bank"), rover("SEV", "A", place(-30, 0)),
                        event("Route", "A", 1, {{"Speed", "1"}}, point(place(40, 0)))});
  EXPECT_EQ(result.outcome.exit_code, 1);
  EXPECT_THAT(result.event("reason"), HasSubstr("rolled over (pitch"));
  EXPECT_EQ(query(result.log, "select count(*) from notes where name = 'rollover'"), "1");
  EXPECT_THAT(query(result.log, "select fields from notes where name = 'rollover'"),
              HasSubstr("roll_rad"));
}

TEST(Findings, wheels_that_spin_without_progress_are_stuck) {
  const TempFolder folder;
  write_terrain(folder, "Hill",
                "lsos.plane { slope_rad = math.rad(28), downslope_azimuth_rad = math.pi }",
                "'ApolloLoose'");
  const RunResult result = run_plan(folder, {on("Hill"), rover("LRV", "A", place(0, 0)),
                                             event("Route", "A", 1, {}, point(place(0, 30)))});
  EXPECT_EQ(result.outcome.exit_code, 1);
  EXPECT_THAT(result.event("reason"), HasSubstr("stuck: no progress in 60 s"));
  const auto fields =
      nlohmann::json::parse(query(result.log, "select fields from notes where name = 'stuck'"));
  EXPECT_GT(fields["slip"], 0.9);
  EXPECT_GT(fields["sinkage_m"], 0.015);
}

TEST(Findings, two_rovers_that_would_touch_stop_before) {
  const TempFolder folder;
  const RunResult result = run_plan(
      folder, {on("Flat", {{"LogInterval", "0.1 s"}}), rover("SEV", "A", place(-15, 0)),
               rover("SEV", "B", place(15, 0.5)), event("Route", "A", 1, {}, point(place(15, 0))),
               event("Route", "B", 1, {}, point(place(-15, 0)))});
  EXPECT_EQ(result.outcome.exit_code, 1);
  EXPECT_THAT(result.event("reason", 0), HasSubstr("would touch B, whose centre is"));
  EXPECT_THAT(result.event("reason", 1), HasSubstr("would touch A, whose centre is"));
  EXPECT_EQ(query(result.log, "select count(*) from notes where name = 'would_touch'"), "2");
  // SEV is 5 m long over its wheels.
  const double nearest_m = std::stod(
      query(result.log,
            "select min(b.x_m - a.x_m) from samples a join samples b on a.time_s = b.time_s and "
            "a.rover_id = 'A' and b.rover_id = 'B'"));
  EXPECT_GT(nearest_m, 5);
  EXPECT_LT(nearest_m, 16);
}

TEST(Findings, are_the_same_when_all_state_is_saved_and_read_at_each_exchange) {
  const TempFolder folder;
  write_terrain(folder, "Hill",
                "lsos.plane { slope_rad = math.rad(28), downslope_azimuth_rad = math.pi }",
                "'ApolloLoose'");
  const std::string plan = folder.write(
      "plan.kml", kml({on("Hill"), rover("LRV", "A", place(0, 0)), rover("LRV", "B", place(0, 8)),
                       event("Route", "A", 1, {{"OnFailure", "skip"}}, point(place(0, 30))),
                       event("Route", "B", 1, {{"OnFailure", "skip"}}, point(place(0, -10))),
                       event("Pause", "B", 2, {{"Duration", "10 s"}})}));
  std::string digests[2];
  for (const int i : {0, 1}) {
    const std::string out = folder / (i == 0 ? "plain" : "saved");
    Words words{plan, "-o", out, "--quiet", "--no-report"};
    if (i == 1) words.push_back("--save-every-exchange");
    run(words);
    digests[i] = summary(out)["log_sha256"];
    EXPECT_NE(query(std::filesystem::path(out) / "log.gpkg", "select count(*) from notes"), "0");
  }
  EXPECT_EQ(digests[0], digests[1]);
}

TEST(Findings, a_rover_that_turns_on_the_spot_does_not_swing_into_another) {
  // The rovers stand side by side, 4.4 m apart; SEV's corners reach 3.1 m when it turns.
  const TempFolder folder;
  const RunResult result =
      run_plan(folder, {on("Flat"), rover("SEV", "A", place(0, 0), {{"Heading", "0"}}),
                        rover("SEV", "B", place(4.4, 0), {{"Heading", "0"}}),
                        event("Route", "A", 1, {}, point(place(-30, -1))),
                        event("Pause", "B", 1, {{"Duration", "10 s"}})});
  EXPECT_EQ(result.outcome.exit_code, 1);
  EXPECT_THAT(result.event("reason"), HasSubstr("would touch B"));
}

TEST(Findings, rovers_may_leave_each_other_and_pass) {
  const TempFolder folder;
  const RunResult result = run_plan(
      folder, {on("Flat"), rover("SEV", "A", place(-20, 0)), rover("SEV", "B", place(20, 5)),
               event("Route", "A", 1, {}, point(place(20, 0))),
               event("Route", "B", 1, {}, point(place(-20, 5)))});
  EXPECT_EQ(result.outcome.exit_code, 0) << result.summary.dump(1);
}

TEST(Parked, for_seven_days_on_20_degrees_a_rover_stays_within_a_millimetre) {
  for (const char* type : {"SEV", "LRV", "MER", "MSL", "VIPER", "Rashid", "ATHLETE", "Husky"}) {
    const TempFolder folder;
    write_terrain(folder, "Slope20", "lsos.plane { slope_rad = math.rad(20) }", "'ApolloNominal'");
    const RunResult result = run_plan(folder, {on("Slope20", {{"ParkedLogInterval", "1 h"}}),
                                               rover(type, "A", place(0, 0), {{"Heading", "30"}}),
                                               event("Pause", "A", 1, {{"Duration", "7 d"}})});
    ASSERT_EQ(result.outcome.exit_code, 0);
    EXPECT_EQ(query(result.log, "select count(*) from samples"), "169");
    for (const char* axis : {"x_m", "y_m", "z_m"}) {
      const double moved_m = std::stod(
          query(result.log, fmt::format("select max({0}) - min({0}) from samples", axis)));
      EXPECT_LT(moved_m, 0.001) << type << " " << axis;
    }
  }
}

TEST(RoverConfig, decides_how_the_rover_starts) {
  double drive_j[2];
  for (const int i : {0, 1}) {
    const TempFolder folder;
    const Fields config = i == 0 ? Fields{} : Fields{{"RoverConfig", "Unloaded"}};
    const RunResult result = run_plan(folder, {on("Flat"), rover("SEV", "A", place(0, 0), config),
                                               event("Route", "A", 1, {}, point(place(50, 0)))});
    ASSERT_EQ(result.outcome.exit_code, 0);
    drive_j[i] = std::stod(query(result.log, "select max(drive_j) from samples"));
    EXPECT_THAT(result.summary["assumptions"].dump(),
                HasSubstr("SEV: drive energy is multiplied by 1 (drive_calibration): not "
                          "calibrated against field data"));
  }
  // The mass is 3000 kg instead of 4000 kg.
  EXPECT_LT(drive_j[1], 0.85 * drive_j[0]);
  EXPECT_GT(drive_j[1], 0.5 * drive_j[0]);
}

}  // namespace
}  // namespace lsos::test
