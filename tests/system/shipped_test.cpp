// Everything that is shipped works: every plan, terrain, rover and soil.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(const std::string& folder, const std::string& ending) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(repository() / folder)) {
    if (entry.path().extension() == ending) found.push_back(entry.path().stem());
  }
  std::ranges::sort(found);
  return found;
}

bool has_scenario(const std::string& plan) {
  return fs::exists(repository() / "tests/scenarios" / (plan + ".lua"));
}

// What `check` warns of, by the plan's name; all else is a fault of the plan or of the program.
TEST(ShippedPlan, is_told_nothing_unexpected) {
  const std::map<std::string, std::vector<std::string>> expected{
      {"drats_day",
       {"DeployCA 'Mast up, A1 camp': by the estimate antenna 'Mast' of A is up from "
        "2010-08-31T20:42:37.500Z to 2010-09-01T13:00:00.000Z and sees neither Earth nor another "
        "end that it reaches; a higher place, another time or an asset that relays helps"}}};
  for (const fs::path& plan : shipped_plans()) {
    const Outcome outcome = run({"check", plan, "--json"});
    const auto answer = nlohmann::json::parse(outcome.out, nullptr, false);
    ASSERT_FALSE(answer.is_discarded()) << plan << "\n" << outcome.out << outcome.err;
    std::vector<std::string> warnings;
    for (const auto& fault : answer["faults"]) {
      EXPECT_EQ(fault["severity"], "warning") << plan << "\n" << fault["what"];
      warnings.push_back(fault["what"]);
    }
    EXPECT_TRUE(answer["is_valid"]) << plan;
    const auto known = expected.find(plan.stem());
    EXPECT_EQ(warnings, known == expected.end() ? std::vector<std::string>{} : known->second)
        << plan;
  }
}

TEST(ShippedPlan, completes) {
  for (const fs::path& plan : shipped_plans()) {
    if (has_scenario(plan.stem())) continue;
    const TempFolder folder;
    const Outcome outcome = run({plan, "-o", folder / "run", "--quiet", "--no-report"});
    EXPECT_EQ(outcome.exit_code, 0) << plan << "\n" << outcome.out << outcome.err;
  }
}

// Plans of studies are made from tables by scripts of ours.
TEST(ShippedPlan, of_a_study_is_as_its_script_writes_it) {
  const TempFolder folder;
  for (const std::string study : {"drats", "lunar_campaign"}) {
    const Outcome outcome =
        run_command({"python3", "-B", repository() / "script/studies" / (study + ".py"),
                     folder.path().string(), "--all"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  for (const std::string plan :
       {"drats.kml", "drats_day.kml", "lunar_campaign.kml", "lunar_campaign_day.kml"}) {
    EXPECT_EQ(read_text(folder / plan), read_text(repository() / "plans" / plan)) << plan;
  }
}

struct Start {
  std::string planet = "Mars", from = "30,-40", to = "30.0003,-40.0001";
};

// Runs a plan in which a rover drives a short distance.
Outcome drive(const TempFolder& folder, const std::string& terrain, const std::string& rover,
              const Start& start = {}) {
  const std::string plan = folder.write(
      "plan.kml",
      kml({{"MissionInfo",
            {{"Planet", start.planet}, {"StartTime", "2026-01-01"}, {"Terrain", terrain}},
            ""},
           {"Rover", {{"RoverId", "A"}, {"RoverType", rover}}, point(start.from)},
           event("Route", "A", 1, {}, point(start.to))}));
  return run({plan, "-o", folder / "run", "--quiet"});
}

TEST(ShippedTerrain, carries_a_rover) {
  // Terrains of a certain place are driven on there, the others anywhere.
  const std::map<std::string, Start> places{
      {"BlackPoint", {"Earth", "-111.47,35.67", "-111.4697,35.6701"}},
      {"LunarSouthPole", {"Moon", "0,-89.5", "0,-89.4990"}}};
  for (const std::string& terrain : names("terrain", ".lua")) {
    const TempFolder folder;
    const auto place = places.find(terrain);
    const Outcome outcome =
        drive(folder, terrain, "SEV", place == places.end() ? Start{} : place->second);
    EXPECT_EQ(outcome.exit_code, 0) << terrain << "\n" << outcome.out << outcome.err;
    EXPECT_GT(summary(folder / "run")["rovers"]["A"]["distance_m"], 10) << terrain;
  }
}

bool is_asset(const std::string& name) {
  return read_text(repository() / "rovers" / (name + ".lua")).find("lsos.asset {") !=
         std::string::npos;
}

TEST(ShippedRover, drives) {
  for (const std::string& rover : names("rovers", ".lua")) {
    if (is_asset(rover)) continue;
    const TempFolder folder;
    const Outcome outcome = drive(folder, "Flat", rover);
    EXPECT_EQ(outcome.exit_code, 0) << rover << "\n" << outcome.out << outcome.err;
  }
}

TEST(ShippedAsset, stands_beside_a_rover) {
  int assets = 0;
  for (const std::string& name : names("rovers", ".lua")) {
    if (!is_asset(name)) continue;
    ++assets;
    const TempFolder folder;
    const std::string plan = folder.write(
        "plan.kml", kml({mission(),
                         sev("A", "30,10"),
                         {"Asset", {{"AssetId", "B"}, {"AssetType", name}}, point("30.001,10")},
                         event("Pause", "A", 1, {{"Duration", "10"}})}));
    const Outcome outcome = run({plan, "-o", folder / "run", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << name << "\n" << outcome.out << outcome.err;
  }
  EXPECT_EQ(assets, 3);
}

TEST(ShippedSoil, is_listed_and_can_be_named_by_a_terrain) {
  const std::string listed = run({"list", "soils"}).out;
  for (const std::string& soil : names("terrain/soils", ".lua")) {
    EXPECT_NE(listed.find(soil + ": "), std::string::npos) << soil << " without its doc";
    const TempFolder folder;
    folder.write(
        "terrain/Mine.lua",
        "-- Level ground of one soil.\n"
        "local lsos = require 'lsos'\n"
        "return lsos.terrain { api = 1, doc = 'Level.', surface = lsos.plane {}, soil = '" +
            soil + "' }\n");
    EXPECT_EQ(drive(folder, "Mine", "SEV").exit_code, 0) << soil;
  }
}

TEST(List, says_what_a_plan_can_name_and_what_that_is) {
  EXPECT_EQ(run({"list", "rovers", "LRV"}).out,
            "LRV: Lunar Roving Vehicle of Apollo 15: four wheels, front and rear steering, two "
            "crew.\n"
            "  RoverConfig OneCrew: Without the right-hand astronaut.\n"
            "  RoverConfig Empty: Without crew and load.\n");
  EXPECT_THAT(run({"list", "rovers", "SEV"}).out,
              testing::HasSubstr("  panels: Roof\n"
                                 "  antennas: Mast (stowed at the start), Whip\n"
                                 "  resources: oxygen (kg), sample bags (bags)\n"));
  EXPECT_THAT(run({"list", "rovers", "Habitat"}).out, testing::StartsWith("Habitat (asset): "));
  EXPECT_THAT(run({"list", "events", "Pause"}).out,
              testing::HasSubstr("\n  drawn as a Point or no geometry\n  Duration "));
  EXPECT_THAT(run({"list", "events", "Consume"}).out, testing::HasSubstr(" number, at least 0 - "));
  EXPECT_EQ(run({"list", "soils", "Rock"}).out, "Rock: Bare rock (assumed friction 0.7).\n");
  EXPECT_EQ(run({"list", "terrains", "Flat"}).out, "Flat: Level ground of nominal lunar soil.\n");
}

TEST(List, gives_configurations_of_rovers_as_json) {
  const auto sev = nlohmann::json::parse(run({"list", "rovers", "SEV", "--json"}).out).at(0);
  EXPECT_EQ(sev.at("name"), "SEV");
  EXPECT_EQ(sev.at("configurations"),
            nlohmann::json::parse(R"([{"name": "Unloaded", "doc": "Without its payload."}])"));
  const auto wait = nlohmann::json::parse(run({"list", "events", "Wait", "--json"}).out).at(0);
  EXPECT_FALSE(wait.contains("configurations"));
  EXPECT_EQ(wait.at("geometries"), nlohmann::json::parse(R"(["none", "point"])"));
  EXPECT_EQ(sev.at("antennas").at(0),
            nlohmann::json::parse(R"({"name": "Mast", "is_stowable": true})"));
  EXPECT_EQ(sev.at("panels"), nlohmann::json::parse(R"(["Roof"])"));
}

TEST(List, leaves_out_what_cannot_be_used) {
  const TempFolder folder;
  folder.write("terrain/soils/Broken.lua", "-- No soil.\nreturn 1\n");
  const Outcome outcome =
      run({"list", "soils"}, {.environment = {"LSOS_PATH=" + folder.path().string()}});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("Broken"), std::string::npos) << outcome.out;
  EXPECT_THAT(outcome.err, ::testing::HasSubstr("terrain/soils/Broken.lua")) << "but it says so";
}

TEST(FirstDrive, holds_its_line_within_half_a_metre) {
  const TempFolder folder;
  ASSERT_EQ(
      run({repository() / "plans" / "first_drive.kml", "-o", folder / "run", "--quiet"}).exit_code,
      0);
  // The drawn line in metres east and north of its start, equal within a decimetre to the plan's
  // degrees on a sphere of radius 1737.4 km.
  const std::vector<std::pair<double, double>> line{{0, 0},     {60, 35},   {150, 40}, {220, 90},
                                                    {215, 170}, {150, 230}, {60, 240}};
  const std::string rows =
      run_command({"sqlite3", folder / "run" / "log.gpkg", "select x_m || ' ' || y_m from samples"})
          .out;
  std::istringstream text(rows);
  double x = 0, y = 0, worst_m = 0;
  int count = 0;
  while (text >> x >> y) {
    double nearest_m = 1e9;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double dx = line[i + 1].first - line[i].first;
      const double dy = line[i + 1].second - line[i].second;
      const double t = std::clamp(
          ((x - line[i].first) * dx + (y - line[i].second) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      nearest_m =
          std::min(nearest_m, std::hypot(x - line[i].first - t * dx, y - line[i].second - t * dy));
    }
    worst_m = std::max(worst_m, nearest_m);
    ++count;
  }
  EXPECT_GT(count, 150);
  EXPECT_LT(worst_m, 0.5);
}

TEST(FullDisk, stops_the_run_and_leaves_what_was_committed) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(long_drive()));
  // No file may grow beyond 1 MiB, so that an insert into the log fails as on a full disk.
  const Words words = program({plan, "-o", folder / "run", "--quiet"});
  std::string command = "ulimit -f 1024; exec";
  for (const std::string& word : words) command += " '" + word + "'";
  const Outcome outcome = run_command({"bash", "-c", command});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("log.gpkg"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "run" / "summary.json"));
  EXPECT_GT(std::stoi("0" + query(folder / "run" / "log.gpkg", "select count(*) from samples")), 0);
}

}  // namespace
}  // namespace lsos::test
