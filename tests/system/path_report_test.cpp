// Planned routes as check reports and keeps them: durations as driven, legs without a route, lines
// across the meridian of 180 degrees.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "base/units.h"
#include "system/plan_run.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A plan in which a rover drives from a place to others, given in metres east and north of it.
std::vector<Mark> route_plan(const std::string& rover, const std::string& terrain,
                             const std::vector<std::pair<double, double>>& to_m,
                             double lon_deg = 20, double lat_deg = 10, const Fields& more = {}) {
  const double radius_m = 1737400;
  std::string places;
  for (const auto& [east_m, north_m] : to_m) {
    const double by_deg = degrees(east_m / (radius_m * std::cos(radians(lat_deg))));
    places += fmt::format("{:.9f},{:.9f} ", std::remainder(lon_deg + by_deg, 360),
                          lat_deg + degrees(north_m / radius_m));
  }
  return {{"MissionInfo",
           {{"Planet", "Moon"},
            {"StartTime", "2026-01-01T00:00:00Z"},
            {"Terrain", terrain},
            {"LogInterval", "60"}},
           ""},
          {"Rover",
           {{"RoverId", "R"}, {"RoverType", rover}},
           point(fmt::format("{:.9f},{:.9f}", lon_deg, lat_deg))},
          event("PathPlanRoute", "R", 1, more, to_m.size() == 1 ? point(places) : line(places))};
}

struct TimedDrive {
  const char *rover, *terrain;
  std::vector<std::pair<double, double>> to_m;
  double within;  // relative tolerance on the driven time
};

class PathPlanTime : public testing::TestWithParam<TimedDrive> {};

TEST_P(PathPlanTime, is_what_the_drive_takes) {
  const TimedDrive& drive = GetParam();
  const PlanRun run(route_plan(drive.rover, drive.terrain, drive.to_m));
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  double planned_s = 0;
  for (const PlannedPathRow& path : run.log().planned_paths()) planned_s += path.duration_s;
  const std::vector<EventRow> events = run.log().events();
  ASSERT_EQ(events.size(), 1u);
  const double driven_s = seconds(*events[0].end) - seconds(*events[0].start);
  RecordProperty("planned_to_driven", fmt::format("{:.3f}", planned_s / driven_s));
  EXPECT_NEAR(planned_s, driven_s, drive.within * driven_s);
}

// Drives on level ground with a sharp corner and without, and up, down and across 10 degrees.
INSTANTIATE_TEST_SUITE_P(Rovers, PathPlanTime,
                         testing::Values(TimedDrive{"SEV", "Flat", {{80, 0}, {80, 60}}, 0.05},
                                         TimedDrive{"MER", "Flat", {{20, 0}, {20, 15}}, 0.05},
                                         TimedDrive{"MSL", "Flat", {{20, 0}, {20, 15}}, 0.05},
                                         TimedDrive{"VIPER", "Flat", {{40, 0}, {40, 30}}, 0.05},
                                         TimedDrive{"Rashid", "Flat", {{20, 0}, {20, 15}}, 0.05},
                                         TimedDrive{"Husky", "Flat", {{40, 0}, {40, 30}}, 0.05},
                                         TimedDrive{"ATHLETE", "Flat", {{40, 0}, {40, 30}}, 0.05},
                                         TimedDrive{"LRV", "Flat", {{120, 0}}, 0.05},
                                         TimedDrive{"SEV", "Slope", {{0, -80}}, 0.1},
                                         TimedDrive{"SEV", "Slope", {{60, 60}}, 0.1},
                                         TimedDrive{"Husky", "Slope", {{0, -30}}, 0.1},
                                         TimedDrive{"Husky", "Slope", {{0, 30}}, 0.1},
                                         TimedDrive{"LRV", "Slope", {{0, -100}}, 0.1},
                                         TimedDrive{"LRV", "Slope", {{100, 0}}, 0.1},
                                         TimedDrive{"LRV", "Slope", {{0, 100}}, 0.1},
                                         TimedDrive{"MER", "Slope", {{0, 20}}, 0.1}),
                         [](const auto& tested) {
                           return fmt::format("{}{}{}", tested.param.rover, tested.param.terrain,
                                              tested.index);
                         });

TEST(PathPlanReport, no_route_is_kept_and_reported_at_once_the_second_time) {
  const TempFolder folder;
  const std::string plan =
      folder.write("plan.kml", read_text(repository() / "tests/messages/mission/no_route.kml"));
  folder.write("terrain/Walled.lua",
               read_text(repository() / "tests/messages/mission/terrain/Walled.lua"));
  const Outcome first = run({"check", plan});
  EXPECT_EQ(first.exit_code, 2);
  const std::filesystem::path kept = plan + ".routes";
  ASSERT_TRUE(std::filesystem::exists(kept));
  const auto written = std::filesystem::last_write_time(kept);
  const Outcome second = run({"check", plan});
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(std::filesystem::last_write_time(kept), written) << "it was planned again";
}

// The goal is on the far wall of a bowl that cannot be crossed. The nearest reachable place lies on
// the route around it, outside the corridor that is searched first.
TEST(PathPlanReport, the_nearest_place_is_offered_also_where_the_way_there_is_round) {
  const TempFolder folder;
  folder.write(
      "terrain/Bowl.lua",
      "local lsos = require 'lsos'\n"
      "return lsos.terrain { api = 1, doc = 'Test.', soil = 'ApolloNominal',\n"
      "  surface = lsos.relief { lon_deg = 20, lat_deg = 10, spacing_m = 2, landforms = {\n"
      "    lsos.landform { name = 'bowl', lon_deg = 20.0066973, lat_deg = 10,\n"
      "      diameter_m = 200, depth_m = 60, rim_height_m = 8 } } } }\n");
  const Outcome check = run(
      {"check", folder.write("plan.kml", kml(route_plan("SEV", "Bowl", {{285, 0}}))), "--quiet"});
  EXPECT_EQ(check.exit_code, 2);
  const std::string output = check.out + check.err,
                    before = "the nearest place that can be reached is ";
  ASSERT_THAT(output, HasSubstr(before));
  const std::string away =
      output.substr(output.find(", ", output.find(before) + before.size()) + 2);
  EXPECT_LT(std::stod(away), 15) << output;
}

// A small rover is to drive 300 m to the floor of a pit.
TEST(PathPlanReport, no_route_is_found_out_in_seconds) {
  const TempFolder folder;
  folder.write("terrain/Pit.lua",
               "local lsos = require 'lsos'\n"
               "return lsos.terrain { api = 1, doc = 'Test.', soil = 'ApolloNominal',\n"
               "  surface = lsos.relief { lon_deg = 20, lat_deg = 10, landforms = {\n"
               "    lsos.landform { name = 'pit', lon_deg = 20, lat_deg = 10.009893,\n"
               "      diameter_m = 40, depth_m = 14, rim_height_m = 2 } } } }\n");
  const std::string plan = folder.write("plan.kml", kml(route_plan("MER", "Pit", {{0, 300}})));
  const auto begin = std::chrono::steady_clock::now();
  const Outcome check = run({"check", plan, "--quiet"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.out, HasSubstr("the nearest place that can be reached is "));
  EXPECT_LT(took.count(), 30) << "it took minutes";
}

TEST(PathPlanReport, a_folder_where_routes_would_be_kept_is_warned_of) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(route_plan("SEV", "Flat", {{20, 0}})));
  std::filesystem::create_directory(plan + ".routes");
  const Outcome check = run({"check", plan});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("plan.kml.routes: warning: holds something else"));
  EXPECT_THAT(check.out, HasSubstr("planned: R 'PathPlanRoute 1' to waypoint 1: "));
}

TEST(PathPlanReport, a_waypoint_that_it_stands_on_is_reported_too) {
  const TempFolder folder;
  const Outcome check =
      run({"check", folder.write("plan.kml", kml(route_plan("SEV", "Flat", {{0, 0}, {20, 0}})))});
  EXPECT_THAT(check.out, HasSubstr("planned: R 'PathPlanRoute 1' to waypoint 1: already there"));
  EXPECT_THAT(check.out, HasSubstr("planned: R 'PathPlanRoute 1' to waypoint 2: 20"));
}

// 31 legs of 5 m.
TEST(PathPlanReport, many_legs_are_summed_up) {
  const TempFolder folder;
  std::vector<std::pair<double, double>> east_north_m;
  for (int k = 0; k < 31; ++k) east_north_m.emplace_back(5.0 * (k + 1), 0);
  const std::string plan = folder.write("plan.kml", kml(route_plan("SEV", "Flat", east_north_m)));
  const Outcome check = run({"check", plan});
  EXPECT_THAT(check.out, HasSubstr("planned: R: 31 legs, 0.2 km, "));
  EXPECT_THAT(check.out, HasSubstr("31 legs in all: --verbose lists them"));
  EXPECT_THAT(check.out, Not(HasSubstr("to waypoint")));
  const Outcome verbose = run({"check", plan, "--verbose"});
  EXPECT_THAT(verbose.out, HasSubstr("planned: R 'PathPlanRoute 1' to waypoint 31: 5.0 m"));
}

TEST(PathPlanReport, lines_go_on_over_the_meridian) {
  const PlanRun run(route_plan("SEV", "Craters", {{0, 0}, {100, 30}}, 179.999, 10, {}));
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  // No point of a line is written with a longitude on the other side of the antimeridian.
  const std::string overlay = read_text(run.folder / "run" / "overlay.kml");
  EXPECT_TRUE(overlay.find(" 180.00") != std::string::npos);
  EXPECT_TRUE(overlay.find(" -179.99") == std::string::npos);
}

}  // namespace
}  // namespace lsos::test
