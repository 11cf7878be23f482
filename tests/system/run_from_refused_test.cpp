// What of a run another cannot begin from is refused, and what a planner should know is said.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "system/moon_ground.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* ended = "2026-01-01T00:01:00Z";

// A minute of standing on 0,0, on ground of a terrain script beside the plan.
struct Standing {
  explicit Standing(const std::string& soil = "'ApolloNominal'", const std::string& seed = "0") {
    write_terrain(folder, "Yard", "lsos.plane { height_m = 5 }", soil);
    folder.write("plan.kml",
                 kml({on("Yard", {{"Seed", seed}}), rover("SEV", "R", place(0, 0)),
                      rover("MER", "S", place(40, 0)), event("Wait", "R", 1, {{"Until", ended}})}));
    outcome = run({"run", folder / "plan.kml", "-o", folder / "a", "--quiet", "--no-report"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  // The plan that goes on, with another field in MissionInfo and other rovers.
  Outcome go_on(const std::vector<Mark>& rovers, const Fields& mission = {},
                const char* command = "run") const {
    Fields fields{{"Planet", "Moon"}, {"StartTime", ended}, {"Terrain", "Yard"}};
    for (const auto& [name, text] : mission) {
      const auto same =
          std::ranges::find(fields, name, &std::pair<std::string, std::string>::first);
      if (same == fields.end()) {
        fields.emplace_back(name, text);
      } else {
        same->second = text;
      }
    }
    std::vector<Mark> marks{{"MissionInfo", fields, ""}};
    marks.insert(marks.end(), rovers.begin(), rovers.end());
    marks.push_back(event("Pause", "R", 1, {{"Duration", "10"}}));
    Words words{command, folder.write("next.kml", kml(marks)), "--from", folder / "a"};
    if (std::string(command) == "run") {
      words.insert(words.end(), {"-o", folder / "b", "--no-report"});
    }
    return run(words);
  }
  std::string a() const { return folder / "a"; }

  TempFolder folder;
  Outcome outcome;
};

void change(const Standing& then, const std::string& sql) {
  const Outcome outcome = run_command({"sqlite3", then.folder / "a" / "log.gpkg", sql});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

std::vector<Mark> same_rovers() {
  return {rover("SEV", "R", place(0, 0)), rover("MER", "S", place(40, 0))};
}

TEST(RunFromRefused, says_nothing_where_all_fits) {
  const Standing then;
  Outcome now = then.go_on(same_rovers());
  EXPECT_EQ(now.exit_code, 0);
  EXPECT_THAT(now.err, Not(HasSubstr(then.a())));
  now = then.go_on(same_rovers(), {}, "check");
  EXPECT_EQ(now.exit_code, 0) << now.out << now.err;
}

TEST(RunFromRefused, a_plan_that_begins_earlier) {
  const Standing then;
  for (const char* command : {"run", "check"}) {
    const Outcome now = then.go_on(same_rovers(), {{"StartTime", "2026-01-01T00:00:59Z"}}, command);
    EXPECT_EQ(now.exit_code, 2);
    EXPECT_THAT(now.err + now.out,
                HasSubstr("next.kml:3: StartTime = 2026-01-01T00:00:59.000Z: " + then.a() +
                          " ended at 2026-01-01T00:01:00.000Z; the plan must not begin before "));
  }
  EXPECT_FALSE(std::filesystem::exists(then.folder / "b"));
}

TEST(RunFromRefused, other_ground_and_other_rovers_all_at_once) {
  const Standing then;
  Outcome now =
      then.go_on({rover("LRV", "R", place(0, 0)),
                  rover("MER", "S", place(40, 0), {{"Variant", "cruise_speed_mps = 0.03"}})},
                 {{"Terrain", "Flat"}, {"StartTime", "2026-01-01T00:00:00Z"}});
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("Terrain = Flat: " + then.a() + " was on Yard; take its Terrain"));
  EXPECT_THAT(now.err, HasSubstr("Rover 'R': RoverType = LRV: in " + then.a() +
                                 " it was SEV; take that, or give the rover another RoverId"));
  EXPECT_THAT(now.err, HasSubstr("Rover 'S': Variant = "));
  EXPECT_THAT(now.err, HasSubstr("the plan must not begin before that"));

  now = then.go_on(same_rovers(), {{"Planet", "Mars"}});
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("Planet = Mars: " + then.a() + " was on Moon; take its Planet"));

  now = then.go_on({rover("SEV", "R", place(0, 0), {{"RoverConfig", "Unloaded"}}),
                    rover("MER", "S", place(40, 0))});
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("Rover 'R': RoverConfig = Unloaded: in " + then.a()));
}

TEST(RunFromRefused, ground_and_rover_scripts_that_have_changed) {
  const Standing then;
  write_terrain(then.folder, "Yard", "lsos.plane { height_m = 5, slope_rad = 0.01 }",
                "'ApolloNominal'");
  const auto sev = std::filesystem::path(LSOS_SOURCE_DIR) / "rovers" / "SEV.lua";
  then.folder.write("rovers/SEV.lua", read_text(sev) + "-- Changed.\n");
  const Outcome now = then.go_on(same_rovers());
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err,
              HasSubstr("terrain Yard is not what it was when " + then.a() + " was run: "));
  EXPECT_THAT(now.err, HasSubstr("SEV.lua: it is not what it was when " + then.a() +
                                 " was run: restore it, or run "));
}

TEST(RunFromRefused, another_seed_of_seeded_ground) {
  const PlanRun then(
      {on("Craters"), rover("SEV", "R", "30,20"), event("Wait", "R", 1, {{"Until", ended}})});
  ASSERT_EQ(then.outcome.exit_code, 0) << then.outcome.err;
  Mark later = on("Craters", {{"Seed", "3"}});
  later.fields[1].second = ended;
  const PlanRun now(
      {later, rover("SEV", "R", "30,20"), event("Pause", "R", 1, {{"Duration", "5"}})},
      {"--from", then.folder / "run"});
  EXPECT_EQ(now.outcome.exit_code, 2);
  EXPECT_THAT(now.outcome.err, HasSubstr("Seed = 3: " + (then.folder / "run").string() +
                                         " had Seed = 0, and other ground; take that"));
}

TEST(RunFromRefused, a_rover_that_had_rolled_over) {
  const Standing then;
  change(then,
         "insert into notes (time_s, rover_id, sequence, name, fields) values "
         "(5, 'R', 1, 'rollover', '{}')");
  const Outcome now = then.go_on(same_rovers());
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("Rover 'R': it had rolled over in " + then.a() +
                                 ": it cannot go on from there"));
}

TEST(RunFromRefused, what_is_no_run_and_the_folder_of_the_run_itself) {
  const Standing then;
  const std::string plan = then.folder / "plan.kml";
  Outcome now = run({"run", plan, "--from", then.folder / "no"});
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("no such file: no run has written it"));

  then.folder.write("next.kml", read_text(plan));
  now = then.go_on(same_rovers());
  now = run({"run", then.folder / "next.kml", "--from", then.a(), "-o", then.a(), "--quiet"});
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("holds the run with whose end this one begins"));
  EXPECT_TRUE(std::filesystem::exists(then.folder / "a" / "summary.json"));

  change(then, "delete from samples");
  now = then.go_on(same_rovers());
  EXPECT_EQ(now.exit_code, 2);
  EXPECT_THAT(now.err, HasSubstr("its log has no sample"));
}

TEST(RunFromRefused, but_what_is_only_unusual_is_warned_of) {
  const Standing then;
  std::filesystem::remove(then.folder / "a" / "summary.json");
  const Outcome now =
      then.go_on({rover("SEV", "R", place(0, 60), {{"InitialCharge", "0.5"}, {"Heading", "90"}}),
                  rover("MER", "T", place(-40, 0))},
                 {{"StartTime", "2026-01-01T00:02:30Z"}});
  EXPECT_EQ(now.exit_code, 0) << now.err;
  EXPECT_THAT(now.err, HasSubstr("StartTime = 2026-01-01T00:02:30.000Z: " + then.a() +
                                 " ended at 2026-01-01T00:01:00.000Z; of the 90 s between nothing "
                                 "is simulated"));
  EXPECT_THAT(now.err, HasSubstr("Rover 'R': its Placemark at 0.000000,0.001979 is 60 m from "));
  EXPECT_THAT(now.err, HasSubstr("Rover 'R': Heading = 90 is not used: it begins with 0.0 deg"));
  EXPECT_THAT(now.err,
              HasSubstr("Rover 'R': InitialCharge = 0.5 is not used: it begins with 1.0000"));
  EXPECT_THAT(now.err,
              HasSubstr("Rover 'T': it is not in " + then.a() + ", and begins as the plan says"));
  EXPECT_THAT(now.err,
              HasSubstr("rover 'S' of " + then.a() + " is not in this plan: it is left out"));
  EXPECT_THAT(now.err, HasSubstr("the run in it did not finish"));
  const nlohmann::json warnings = summary(then.folder / "b")["warnings"];
  EXPECT_EQ(warnings.size(), 7u) << warnings;
}

TEST(RunFromRefused, other_soil_is_warned_of) {
  TempFolder folder;
  const auto soil = std::filesystem::path(LSOS_SOURCE_DIR) / "terrain/soils/ApolloNominal.lua";
  folder.write("terrain/soils/Loose.lua", read_text(soil));
  write_terrain(folder, "Yard", "lsos.plane { height_m = 5 }", "'Loose'");
  const auto go = [&](const std::string& start, const Words& more) {
    Mark mission = on("Yard");
    mission.fields[1].second = start;
    Words words{"run",
                folder.write("plan.kml", kml({mission, rover("SEV", "R", place(0, 0)),
                                              event("Pause", "R", 1, {{"Duration", "60"}})})),
                "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  EXPECT_EQ(go("2026-01-01", {"-o", folder / "a"}).exit_code, 0);
  std::string other = read_text(soil);
  const std::size_t at = other.find("cohesion_pa");
  ASSERT_NE(at, std::string::npos);
  other.insert(other.find('=', at) + 1, " 1.01 *");
  folder.write("terrain/soils/Loose.lua", other);
  const Outcome now = go("2026-01-01T00:02:00Z", {"-o", folder / "b", "--from", folder / "a"});
  EXPECT_EQ(now.exit_code, 0) << now.err;
  EXPECT_THAT(now.err, HasSubstr("Yard: its soil is not what it was in "));
}

}  // namespace
}  // namespace lsos::test
