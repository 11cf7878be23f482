// `lsos-host new`: its files work without changes.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "system/process.h"
#include "system/run_folder.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

TEST(New, event_is_a_script_and_a_scenario_that_passes) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  EXPECT_EQ(run({"new", "event", "DropBeacon"}, there).exit_code, 0);
  const Outcome outcome = run({"test"}, there);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ok 1 - tests/scenarios/DropBeacon.lua"));
  const Outcome other = run({"new", "event", "Fetch", "--json"}, there);
  EXPECT_EQ(other.out,
            "{\"event\":\"events/Fetch.lua\",\"scenario\":\"tests/scenarios/Fetch.lua\"}\n");
  // A file for editors, written once, refers to the library of the lsos module.
  const auto settings = nlohmann::json::parse(read_text(folder / ".luarc.json"));
  EXPECT_TRUE(std::filesystem::exists(settings["workspace.library"][0].get<std::string>()));
  const Outcome again = run({"new", "event", "DropBeacon"}, there);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("there is an event 'DropBeacon' already"));
  const Outcome wrong = run({"new", "event", "drop-beacon"}, there);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("'drop-beacon' cannot be an event's name"));
}

TEST(New, rover_differs_from_a_shipped_one_and_drives) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  EXPECT_EQ(run({"new", "rover", "SEV60"}, there).exit_code, 0);
  EXPECT_EQ(run({"new", "rover", "Buggy", "--from", "LRV"}, there).exit_code, 0);
  const Outcome outcome = run({"test"}, there);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ok 2 - tests/scenarios/SEV60.lua: SEV60 drives 30 m"));
  EXPECT_THAT(run({"new", "rover", "SEV"}, there).err, HasSubstr("there is a rover 'SEV' already"));
  EXPECT_THAT(run({"new", "rover", "X", "--from", "SVE"}, there).err,
              HasSubstr("no rover type 'SVE'; did you mean 'SEV'?"));
  EXPECT_THAT(run({"new", "rover", "a b"}, there).err, HasSubstr("'a b' cannot be a name"));
}

TEST(New, plan_can_be_run_on_each_planet) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  struct Asked {
    std::string name;
    std::vector<std::string> options;
  };
  const Asked all[] = {
      {"first", {}},
      {"pole", {"--terrain", "LunarSouthPole", "--site", "80,-84.7", "--from", "LRV"}},
      {"at_the_pole", {"--terrain", "Flat", "--site", "0,-89.9999"}},
      {"mars", {"--planet", "Mars", "--terrain", "Flat", "--site", "137.4,-4.6"}},
      {"earth", {"--planet", "Earth", "--terrain", "BlackPoint", "--site=-111.48,35.68"}}};
  for (const Asked& asked : all) {
    std::vector<std::string> command{"new", "plan", asked.name};
    command.insert(command.end(), asked.options.begin(), asked.options.end());
    ASSERT_EQ(run(command, there).exit_code, 0);
    const Outcome outcome = run({asked.name + ".kml", "--quiet", "--no-report"}, there);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("3 of 3 events completed"));
  }
  EXPECT_THAT(run({"new", "plan", "first"}, there).err, HasSubstr("first.kml: is there already"));
  EXPECT_THAT(run({"new", "plan", "x", "--planet", "Pluto"}, there).err, HasSubstr("Pluto"));
}

TEST(New, terrain_is_ground_that_a_plan_can_name) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  std::filesystem::copy(repository() / "tests/messages/mission/shown.asc", folder / "dem.asc");
  EXPECT_EQ(run({"new", "terrain", "Mine"}, there).exit_code, 0);
  EXPECT_EQ(run({"new", "terrain", "Dem", "--from", "dem.asc"}, there).exit_code, 0);
  const Outcome heights = run({"terrain", "Mine", "--site", "0,0", "--at", "0,0"}, there);
  EXPECT_EQ(heights.exit_code, 0) << heights.err;
  EXPECT_EQ(run({"list", "terrains", "Dem"}, there).exit_code, 0);
  EXPECT_THAT(read_text(folder / "terrain/Dem.lua"), HasSubstr("file = '../dem.asc'"));
  EXPECT_THAT(run({"new", "terrain", "T", "--from", "no.tif"}, there).err,
              HasSubstr("no.tif: there is no such file"));
}

TEST(New, names_and_paths_may_hold_anything) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  EXPECT_EQ(run({"new", "rover", "BASECAMP"}, there).exit_code, 0);
  EXPECT_THAT(read_text(folder / "rovers/BASECAMP.lua"), HasSubstr("'BASECAMP: its mass"));
  EXPECT_EQ(run({"new", "rover", "MASSIVE"}, there).exit_code, 0);
  EXPECT_EQ(run({"new", "rover", "Three", "--from", "MASSIVE"}, there).exit_code, 0);
  EXPECT_EQ(run({"list", "rovers", "Three"}, there).exit_code, 0);
  std::filesystem::copy(repository() / "tests/messages/mission/shown.asc", folder / "it's.asc");
  EXPECT_EQ(run({"new", "terrain", "Quoted", "--from", "it's.asc"}, there).exit_code, 0);
  EXPECT_EQ(run({"list", "terrains", "Quoted"}, there).exit_code, 0);
}

TEST(New, options_that_say_nothing_are_refused) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  EXPECT_THAT(run({"new", "event", "Zed", "--from", "x"}, there).err,
              HasSubstr("--from says nothing of a new event"));
  EXPECT_THAT(run({"new", "rover", "Zed", "--site", "1,2"}, there).err,
              HasSubstr("--site says nothing of a new rover"));
  EXPECT_THAT(run({"new", "plan", "z", "--terrain", "Crater"}, there).err,
              HasSubstr("there is no such terrain and no such file; did you mean 'Craters'?"));
}

TEST(New, scenario_passes) {
  const TempFolder folder;
  const Surroundings there{folder.path()};
  EXPECT_EQ(run({"new", "scenario", "far"}, there).exit_code, 0);
  EXPECT_EQ(run({"test"}, there).exit_code, 0);
}

}  // namespace
}  // namespace lsos::test
