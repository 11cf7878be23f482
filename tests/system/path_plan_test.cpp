// PathPlanRoute: its routes in check and in runs, and the routes that are kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A route to a place 150 m north of the start across the synthetic craters, with a bend.
std::vector<Mark> crossing(const Fields& more = {}) {
  return {mission({{"Terrain", "Craters"}, {"Seed", "3"}, {"LogInterval", "1"}}),
          sev("SEV1", "0,0"),
          event("PathPlanRoute", "SEV1", 1, more, line("0,0 0.0012,0.0025 0,0.005"))};
}

// Removes the Terrain that mission() gives.
std::vector<Mark> on_craters(std::vector<Mark> plan) {
  std::erase_if(plan[0].fields, [](const auto& field) {
    return field.first == "Terrain" && field.second == "Flat";
  });
  return plan;
}

double off_m(const std::vector<PlannedPathRow>& paths, const Geodetic& place) {
  const double radius_m = 1737400;
  double least_m = 1e9;
  for (const PlannedPathRow& path : paths) {
    for (std::size_t k = 0; k + 1 < path.line.size(); ++k) {
      const auto flat = [&](const Geodetic& at) {
        return Vec2(radius_m * (at.lon_rad - place.lon_rad) * std::cos(place.lat_rad),
                    radius_m * (at.lat_rad - place.lat_rad));
      };
      const Vec2 from_m = flat(path.line[k]), way_m = flat(path.line[k + 1]) - from_m;
      const double share = std::clamp(-from_m.dot(way_m) / way_m.squaredNorm(), 0.0, 1.0);
      least_m = std::min(least_m, (from_m + share * way_m).norm());
    }
  }
  return least_m;
}

TEST(PathPlan, is_driven_as_it_was_planned) {
  const PlanRun run(on_craters(crossing()));
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const std::vector<PlannedPathRow> paths = run.log().planned_paths();
  ASSERT_EQ(paths.size(), 2u) << "a leg to each waypoint but the first, where it stands";
  double length_m = 0, energy_j = 0, duration_s = 0;
  for (const PlannedPathRow& path : paths) {
    EXPECT_EQ(path.time, SimTime{});
    EXPECT_EQ(path.attempt, 0);
    EXPECT_LT(off_m(paths, path.steepest), 0.1);
    length_m += path.length_m;
    energy_j += path.energy_j;
    duration_s += path.duration_s;
  }
  EXPECT_EQ(paths[0].leg, 2);
  EXPECT_EQ(paths[1].leg, 3);
  const std::vector<SampleRow> samples = run.samples();
  for (const SampleRow& row : samples) EXPECT_LT(off_m(paths, row.place), 0.5) << seconds(row.time);
  const SampleRow& last = samples.back();
  EXPECT_NEAR(last.distance_m, length_m, 0.02 * length_m);
  // The plan neglects corners at waypoints and unequal wheel loads.
  EXPECT_NEAR(last.drive_j, energy_j, 0.05 * energy_j);
  EXPECT_GT(seconds(last.time), duration_s);
  const std::string overlay = read_text(run.folder / "run" / "overlay.kml");
  EXPECT_THAT(overlay, HasSubstr("SEV1 event 1 to waypoint 2 (planned)"));
  EXPECT_THAT(overlay, HasSubstr("SEV1 driven"));
}

TEST(PathPlan, is_told_by_check_and_kept_beside_the_plan) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(on_craters(crossing())));
  const Outcome first = run({"check", plan});
  EXPECT_EQ(first.exit_code, 0) << first.out;
  EXPECT_THAT(first.out, HasSubstr("planned: SEV1 'PathPlanRoute 1' to waypoint 2: "));
  EXPECT_THAT(first.out, HasSubstr(" Wh, steepest "));
  const auto kept = std::filesystem::path(plan + ".routes");
  ASSERT_TRUE(std::filesystem::exists(kept));
  const auto written = std::filesystem::last_write_time(kept);
  const auto json = nlohmann::json::parse(run({"check", plan, "--json"}).out);
  ASSERT_EQ(json["planned_paths"].size(), 2u);
  EXPECT_EQ(json["planned_paths"][0]["leg"], 2);
  EXPECT_GT(json["planned_paths"][0]["length_m"], 80);
  EXPECT_LT(json["planned_paths"][0]["slope_max_deg"], 40);
  EXPECT_EQ(std::filesystem::last_write_time(kept), written) << "it was planned again";
  // Another limit gives another route.
  folder.write("plan.kml", kml(on_craters(crossing({{"MaxSlope", "9"}}))));
  EXPECT_EQ(run({"check", plan}).exit_code, 0);
  EXPECT_NE(std::filesystem::last_write_time(kept), written);
}

TEST(PathPlan, is_the_same_kept_or_planned_again) {
  const TempFolder folder;
  const std::string first = digest_of(folder, on_craters(crossing()));
  const std::string kept = digest_of(folder, on_craters(crossing()), {"--force"});
  std::filesystem::remove(folder / "plan.kml.routes");
  const std::string again =
      digest_of(folder, on_craters(crossing()), {"--force", "--save-every-exchange"});
  EXPECT_EQ(first, kept);
  EXPECT_EQ(first, again);
}

// Several rovers are planned for at the same time.
TEST(PathPlan, is_the_same_on_any_threads) {
  const TempFolder folder;
  std::vector<Mark> marks = on_craters(crossing());
  for (const std::string id : {"SEV2", "SEV3"}) {
    const std::string east = id == "SEV2" ? "0.004" : "-0.004";
    marks.push_back(sev(id, east + ",0"));
    marks.push_back(event("PathPlanRoute", id, 1, {}, line(east + ",0 0,0.006")));
  }
  const std::string plan = folder.write("plan.kml", kml(marks));
  const auto answer = [&](const std::string& threads) {
    std::filesystem::remove(plan + ".routes");
    const Outcome outcome = run({"check", plan, "--json", "--threads", threads});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return std::pair(outcome.out, read_text(plan + ".routes"));
  };
  const auto one = answer("1");
  EXPECT_EQ(nlohmann::json::parse(one.first)["planned_paths"].size(), 4u);
  EXPECT_EQ(one, answer("2"));
  EXPECT_EQ(one, answer("3"));
}

// An LRV that faces a habitat two metres ahead and cannot turn on the spot.
TEST(PathPlan, backs_up_as_it_was_planned) {
  const PlanRun run({mission({{"LogInterval", "1"}}),
                     {"Asset", {{"AssetId", "Hab"}, {"AssetType", "Habitat"}}, point("0,0")},
                     {"Rover",
                      {{"RoverId", "LRV1"}, {"RoverType", "LRV"}, {"Heading", "180"}},
                      point("0,0.00033")},
                     event("PathPlanRoute", "LRV1", 1, {}, point("0,-0.0014"))});
  ASSERT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const Outcome check = test::run({"check", run.folder / "plan.kml"});
  EXPECT_THAT(check.out, HasSubstr(", backs up with 2 gear changes\n"));
  const std::vector<PlannedPathRow> paths = run.log().planned_paths();
  ASSERT_EQ(paths.size(), 1u);
  double north_deg = 0, driven_deg = 0;
  for (const Geodetic& at : paths[0].line) north_deg = std::max(north_deg, lat_deg(at));
  const std::vector<SampleRow> samples = run.samples();
  for (const SampleRow& row : samples) {
    EXPECT_LT(off_m(paths, row.place), 0.4) << seconds(row.time);
    driven_deg = std::max(driven_deg, lat_deg(row.place));
  }
  EXPECT_GT(north_deg, 0.00035);
  EXPECT_NEAR(driven_deg, north_deg, 1e-5) << "it did not back up so far";
  const SampleRow& last = samples.back();
  std::printf("driven %.1f m, planned %.1f m; %.0f s, planned %.0f s; %.0f J, planned %.0f J\n",
              last.distance_m, paths[0].length_m, seconds(last.time), paths[0].duration_s,
              last.drive_j, paths[0].energy_j);
  EXPECT_NEAR(last.distance_m, paths[0].length_m, 0.03 * paths[0].length_m);
  EXPECT_NEAR(last.drive_j, paths[0].energy_j, 0.15 * paths[0].energy_j);
  EXPECT_NEAR(seconds(last.time), paths[0].duration_s, 0.15 * paths[0].duration_s);
}

// A rover on a slope of loose sand slips off its path after a sharp corner.
TEST(PathPlan, is_made_anew_when_the_rover_strays) {
  const auto plan = [](const std::string& replans) {
    return std::vector<Mark>{
        {"MissionInfo",
         {{"Planet", "Moon"}, {"StartTime", "2026-01-01T00:00:00Z"}, {"Terrain", "SandSlope"}},
         ""},
        sev("SEV1", "0,0"),
        event("PathPlanRoute", "SEV1", 1, {{"MaxStray", "0.5"}, {"Replans", replans}},
              line("0,0 0.002,0 0.002,0.0002 0.004,0.0002"))};
  };
  const TempFolder folder;
  folder.write(
      "terrain/SandSlope.lua",
      "local lsos = require 'lsos'\n"
      "return lsos.terrain { api = 1, doc = 'Test.', soil = 'DrySand',\n"
      "  surface = lsos.plane { slope_rad = math.rad(14), downslope_azimuth_rad = math.pi } "
      "}\n");
  const auto go = [&](const std::string& replans) {
    return run({"run", folder.write("plan.kml", kml(plan(replans))), "-o", folder / "run",
                "--force", "--quiet"});
  };
  EXPECT_EQ(go("3").exit_code, 0);
  const LogReader log(folder / "run" / "log.gpkg");
  std::vector<std::string> names;
  for (const NoteRow& note : log.notes()) names.push_back(note.name);
  EXPECT_THAT(names, ::testing::ElementsAre("strayed", "replan"));
  const std::vector<PlannedPathRow> paths = log.planned_paths();
  ASSERT_EQ(paths.size(), 4u) << "three legs before the start, the last of them again";
  EXPECT_EQ(paths[3].leg, 4);
  EXPECT_EQ(paths[3].attempt, 1);
  EXPECT_GT(paths[3].time, SimTime{});
  // Without replanning, as in the paper, the event fails.
  EXPECT_EQ(go("0").exit_code, 1);
  EXPECT_THAT(std::string(summary(folder / "run")["events"][0]["reason"]),
              HasSubstr("strayed 0.5 m from its path"));
}

}  // namespace
}  // namespace lsos::test
