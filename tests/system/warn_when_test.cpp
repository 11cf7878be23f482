// WarnWhen: told each time its condition begins to hold, in note, warning, overlay and report; it
// changes nothing else.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "system/killed_runs.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// SEV1 pauses parked, then drives; its condition begins to hold at 0, 20 and 40 s of the pause.
std::vector<Mark> warned_plan(const Fields& of_pause, const Fields& of_route) {
  Fields pause{{"Duration", "55"}};
  pause.insert(pause.end(), of_pause.begin(), of_pause.end());
  return {mission({{"LogInterval", "1"}}), sev("SEV1", "0,0"), event("Pause", "SEV1", 10, pause),
          event("Route", "SEV1", 20, of_route, point("0.002,0"))};
}

std::vector<Mark> warned_plan() {
  return warned_plan({{"WarnWhen", "time_s % 20 &lt; 10"}},
                     {{"WarnWhen", "distance_m > 10.5 and speed_mps > 0.4"}});
}

// All rows of an answer, a line each.
std::string rows(const std::string& log, const std::string& sql) {
  const Outcome outcome = run_command({"sqlite3", log, sql});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out;
}

TEST(WarnWhen, is_told_each_time_it_begins_to_hold) {
  const TempFolder folder;
  const std::string dir = folder / "run";
  const Outcome outcome =
      run({folder.write("plan.kml", kml(warned_plan())), "-o", dir, "--no-report"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;

  const std::string log = folder / "run/log.gpkg";
  EXPECT_EQ(rows(log, "select time_s from notes where name = 'warn_when' and sequence = 10"),
            "0.0\n20.0\n40.0\n");
  EXPECT_EQ(query(log, "select fields from notes where name = 'warn_when' and time_s = 20"),
            R"({"condition":"time_s % 20 < 10","event":"Pause 10"})");
  // The first whole second at which the rover had driven 10.5 m.
  EXPECT_EQ(query(log, "select count(*) from notes where name = 'warn_when' and sequence = 20"),
            "1");
  EXPECT_EQ(
      query(log,
            "select n.time_s - min(s.time_s) from notes n, samples s where n.name = 'warn_when' "
            "and n.sequence = 20 and s.distance_m > 10.5"),
      "0.0");

  const std::vector<std::string> warnings = summary(dir)["warnings"];
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_EQ(warnings[1],
            "SEV1: at 20 s WarnWhen of Pause 'Pause 10' begins to hold: time_s % 20 < 10; time_s "
            "was 20");
  EXPECT_THAT(warnings[3], HasSubstr("WarnWhen of Route 'Route 20' begins to hold: distance_m > "
                                     "10.5 and speed_mps > 0.4; distance_m was 1"));
  EXPECT_THAT(outcome.err, HasSubstr("warning: SEV1: at 40 s WarnWhen of"));
  EXPECT_THAT(read_text(folder / "run/overlay.kml"),
              HasSubstr("<styleUrl>#note-warning</styleUrl>"));
}

TEST(WarnWhen, changes_nothing_of_the_run) {
  const TempFolder folder;
  const auto results = [&](const std::string& name, const std::vector<Mark>& marks) {
    const Outcome outcome =
        run({folder.write(name + ".kml", kml(marks)), "-o", folder / name, "--no-report"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string log = folder / (name + "/log.gpkg");
    return rows(log, "select * from samples") + rows(log, "select * from events");
  };
  const std::string warned = results("warned", warned_plan());
  EXPECT_GT(std::ranges::count(warned, '\n'), 60);
  EXPECT_EQ(warned, results("plain", warned_plan({}, {})));
}

TEST(WarnWhen, is_told_the_same_when_all_state_is_saved_and_read_back) {
  const std::string digest = digest_of(TempFolder(), warned_plan(), {});
  EXPECT_EQ(digest.size(), 64u);
  EXPECT_EQ(digest_of(TempFolder(), warned_plan(), {"--save-every-exchange"}), digest);
}

TEST(WarnWhen, and_stop_when_of_one_condition_are_both_told) {
  const TempFolder folder;
  const Outcome outcome =
      run({folder.write(
               "plan.kml",
               kml(warned_plan({{"WarnWhen", "time_s > 29"}, {"StopWhen", "time_s > 29"}}, {}))),
           "-o", folder / "run", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(rows(folder / "run/log.gpkg", "select name, time_s from notes order by fid"),
            "warn_when|30.0\nstop_when|30.0\n");
}

TEST(WarnWhen, whose_script_fails_is_told_once_and_stops_nothing) {
  const TempFolder folder;
  const Fields fails{{"WarnWhen", "(time_s > 30 and time_s &lt; 40 and 'a' or 1) > 2"}};
  const Outcome outcome = run(
      {folder.write("plan.kml", kml(warned_plan(fails, {}))), "-o", folder / "run", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> warnings = summary(folder / "run")["warnings"];
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0],
              HasSubstr("Pause 'Pause 10' at 31 s: WarnWhen = (time_s > 30 and time_s < 40 "
                        "and 'a' or 1) > 2: attempt to compare number with string"));
}

class KilledWarnings : public KilledRuns {};

TEST_F(KilledWarnings, are_told_once_though_the_run_is_resumed) {
  std::vector<Mark> plan{
      mission(), sev("SEV1", "0,0"),
      event("Route", "SEV1", 10, {{"Speed", "2"}, {"WarnWhen", "time_s % 50 > 20"}},
            line("0,0 0.02,0"))};
  whole_run(plan);
  kill_and_resume(2);
}

}  // namespace
}  // namespace lsos::test
