// Slip while driving in summary.json and in conditions, compared with the rows of the log.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "system/plan_run.h"

namespace lsos::test {
namespace {

constexpr double cruise_mps = 2;  // of SEV

struct Slips {
  double greatest_mean = -1;  // greatest mean over ten rows, 0.1 s apart
  std::vector<double> all;    // ascending
};

// Slips of the rows in which the rover drives; a row describes the period before it.
Slips slips_of(const std::vector<SampleRow>& rows, double requested_mps) {
  Slips slips;
  std::vector<double> last;
  for (const SampleRow& row : rows) {
    const bool is_driving = row.phase == "drive" && !std::isnan(row.slip) &&
                            row.speed_mps > std::max(0.05, requested_mps / 2);
    if (!is_driving) {
      last.clear();
      continue;
    }
    slips.all.push_back(row.slip);
    last.push_back(row.slip);
    if (last.size() < 10) continue;
    double sum = 0;
    for (auto at = last.end() - 10; at != last.end(); ++at) sum += *at;
    slips.greatest_mean = std::max(slips.greatest_mean, sum / 10);
  }
  std::ranges::sort(slips.all);
  return slips;
}

TEST(Slip, of_a_straight_drive_on_the_level_is_what_its_rows_say) {
  const PlanRun run(
      {mission({{"LogInterval", "0.1"}}), sev("R1", "31,12"),
       event("Route", "R1", 10, {{"StopWhen", "slip &gt; 0.13"}}, line("31,12 31.0033715,12"))});
  EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.out;
  const std::vector<SampleRow> rows = run.samples();
  // Conditions are evaluated at whole seconds.
  const auto after_a_second = std::ranges::find(rows, SimTime{1'000'000}, &SampleRow::time);
  ASSERT_NE(after_a_second, rows.end());
  EXPECT_GT(after_a_second->slip, 0.13) << "it sets off";
  const Slips slips = slips_of(rows, cruise_mps);
  const auto rover = run.summary()["rovers"]["R1"];
  EXPECT_NEAR(rover["max_slip"].get<double>(), slips.greatest_mean, 1e-9);
  const auto rank =
      static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(slips.all.size())));
  EXPECT_NEAR(rover["p95_slip"].get<double>(), slips.all[rank - 1], 1e-4);
  EXPECT_GT(slips.all.size(), 300u);
  // One wheel of SEV pulls nothing at this slip, which is what driving on the level takes.
  EXPECT_NEAR(slips.all[slips.all.size() / 2], 0.04, 0.005);
  EXPECT_LT(rover["max_slip"].get<double>(), 0.15) << "it speeds up from half its speed on";
  EXPECT_NEAR(run.summary()["events"][0]["distance_m"].get<double>(), 100, 2)
      << "setting off is no reason to stop";
  EXPECT_GE(rover["duration_s"].get<double>(), rover["drive_s"].get<double>());
}

TEST(Slip, is_null_of_a_rover_that_never_drives) {
  const PlanRun run({mission(), sev("R1", "0,0"), event("Pause", "R1", 1, {{"Duration", "9"}})});
  const auto rover = run.summary()["rovers"]["R1"];
  EXPECT_TRUE(rover["max_slip"].is_null());
  EXPECT_TRUE(rover["p95_slip"].is_null());
}

// On a slope of 28 degrees in loose soil the wheels spin in place; one second of that ends the
// event.
TEST(Slip, of_wheels_that_spin_in_their_place_is_what_a_condition_stops_on) {
  TempFolder folder;
  folder.write("terrain/Hill.lua",
               "local lsos = require 'lsos'\n"
               "return lsos.terrain { api = 1, doc = 'Test.', surface = lsos.plane { slope_rad = "
               "math.rad(28), downslope_azimuth_rad = math.pi }, soil = 'ApolloLoose' }\n");
  const std::string plan = folder.write(
      "plan.kml", kml({{"MissionInfo",
                        {{"Planet", "Moon"}, {"StartTime", "2026-01-01"}, {"Terrain", "Hill"}},
                        ""},
                       {"Rover", {{"RoverId", "A"}, {"RoverType", "LRV"}}, point("0,0")},
                       event("Route", "A", 1, {{"StopWhen", "slip &gt; 0.5"}}, point("0,0.001"))}));
  const Outcome outcome = run({plan, "-o", folder / "run", "--quiet", "--no-report"});
  const auto of_run = summary(folder / "run");
  ASSERT_TRUE(of_run.is_object()) << outcome.err;
  EXPECT_LT(of_run["events"][0]["end_s"].get<double>(), 20);
  EXPECT_EQ(
      query(folder / "run" / "log.gpkg", "select count(*) from notes where name = 'stop_when'"),
      "1");
  EXPECT_EQ(query(folder / "run" / "log.gpkg", "select count(*) from notes where name = 'stuck'"),
            "0");
}

}  // namespace
}  // namespace lsos::test
