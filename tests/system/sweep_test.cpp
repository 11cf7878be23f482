// Studies as a user runs them: many cases of a plan on the processors of one machine.
#include <gmock/gmock.h>

#include <filesystem>

#include "support/sanitizer.h"
#include "system/killed_sweep.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* speeds =
    "    lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' } },\n"
    "    lsos.vary { of = 'Rover A.InitialCharge', list = { 0.5, 0.9 } },";

class Sweep : public ::testing::Test {
 protected:
  void write(const std::vector<Mark>& marks, const std::string& study) {
    folder_.write("plan.kml", kml(marks));
    folder_.write("study.lua", study);
  }

  Outcome sweep(Words words, const std::string& out = "out") {
    words.insert(words.begin(), "sweep");
    for (const char* more : {"study.lua", "--quiet", "-o"}) words.emplace_back(more);
    words.push_back(out);
    return run(words, {.folder = folder_.path()});
  }

  TempFolder folder_;
};

TEST_F(Sweep, leaves_a_row_a_case) {
  write(short_plan(), study_text("cases = 4, gather = { lsos.gather { event = 'A/10', quantity = "
                                 "'speed_mps', at = 'start' }, lsos.gather { rover = 'A', take = "
                                 "'greatest', quantity = 'speed_mps', name = 'fastest' } },",
                                 speeds));
  const Outcome outcome = sweep({"-j", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("4 of 4 cases done (4 completed)"));
  const json cases = rows(folder_ / "out", "SELECT * FROM cases ORDER BY \"case\"");
  ASSERT_EQ(cases.size(), 4u);
  for (const json& row : cases) {
    EXPECT_EQ(row["status"], "completed");
    EXPECT_TRUE(row["reason"].is_null());
    EXPECT_NEAR(row["A_distance_m"], 10, 0.7);
    // It drives the last metre more slowly than what was asked for, but never faster.
    EXPECT_NEAR(row["fastest"], row["A/10.Speed"], 0.05);
    EXPECT_NEAR(row["A_energy_start_j"], 144e6 * double{row["Rover A.InitialCharge"]}, 1);
    EXPECT_EQ(row["log_sha256"].get<std::string>().size(), 64u);
    const std::string name = "out/cases/00000" + std::to_string(row["case"].get<int>());
    const json summary = json::parse(read_text(folder_ / (name + "/summary.json")));
    EXPECT_EQ(summary["log_sha256"], row["log_sha256"]);
    EXPECT_FALSE(fs::exists(folder_ / (name + "/log.gpkg"))) << "keep = 'none'";
  }
  EXPECT_NE(cases[0]["A/10.Speed"], cases[1]["A/10.Speed"]);
  const json speed = rows(folder_ / "out", "SELECT * FROM columns WHERE name = 'A/10.Speed'");
  EXPECT_EQ(speed[0]["kind"], "parameter");
  EXPECT_EQ(speed[0]["unit"], "m/s");
}

TEST_F(Sweep, has_bands_that_hold_its_cases) {
  write(short_plan(), study_text("cases = 5, interval_s = 2,", speeds));
  ASSERT_EQ(sweep({"-j", "2"}).exit_code, 0);
  const json bands =
      rows(folder_ / "out", "SELECT * FROM bands WHERE quantity = 'distance_m' ORDER BY time_s");
  ASSERT_GT(bands.size(), 20u);
  double last_m = 0;
  for (const json& row : bands) {
    EXPECT_LE(row["p5"], row["p50"]);
    EXPECT_LE(row["p50"], row["p95"]);
    EXPECT_GE(double{row["p50"]}, last_m - 1e-9) << "what is driven is not lost";
    last_m = row["p50"];
  }
  EXPECT_EQ(bands[0]["p95"], 0.0);
  EXPECT_EQ(bands[0]["share_reached"], 1.0);
  const json arrivals = all_rows(folder_ / "out", "arrivals");
  ASSERT_EQ(arrivals.size(), 2u);
  EXPECT_EQ(arrivals[0]["share_reached"], 1.0);
  EXPECT_LT(arrivals[0]["end_s_p5"], arrivals[0]["end_s_p95"]);
  EXPECT_NEAR(double{arrivals[1]["end_s_p50"]} - double{arrivals[0]["end_s_p50"]}, 60, 0.3);
}

TEST_F(Sweep, gives_the_same_rows_with_any_number_of_processes) {
  write(short_plan(), study_text("cases = 4, sampling = 'sobol',", speeds));
  ASSERT_EQ(sweep({"-j", "1"}, "one").exit_code, 0);
  // In another order, as the processes of a cluster would.
  ASSERT_EQ(sweep({"run", "--cases", "3-4", "-j", "2"}, "two").exit_code, 0);
  const Outcome rest = sweep({"run", "--cases", "1,2"}, "two");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_THAT(rest.out, HasSubstr("2 of 2 cases done")) << "those that it was asked for";
  ASSERT_EQ(sweep({"gather"}, "two").exit_code, 0);
  EXPECT_EQ(equal_parts(folder_ / "one"), equal_parts(folder_ / "two"));
}

// The rover is a script beside the plan: it is found from the folder of a case, too.
TEST_F(Sweep, makes_cases_that_run_alone) {
  folder_.write("rovers/Mine.lua",
                "local lsos = require 'lsos'\n"
                "return lsos.derive('SEV', { doc = 'Mine.', cruise_speed_mps = 1.2 })\n");
  std::vector<Mark> marks = short_plan();
  for (auto& [name, value] : marks[1].fields) {
    if (name == "RoverType") value = "Mine";
  }
  write(marks, study_text("cases = 2,", std::string(speeds) +
                                            "lsos.vary { of = 'A/10.Place', within = '5 m' },"
                                            "lsos.vary { of = 'Soil.friction_rad', factor = true, "
                                            "uniform = { 0.9, 1 } },"));
  const Outcome swept = sweep({});
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  const Outcome alone = run({"cases/000002/plan.kml", "-o", "alone", "--no-report", "--quiet"},
                            {.folder = folder_ / "out"});
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  const auto digest = [&](const std::string& file) {
    return json::parse(read_text(folder_ / file))["log_sha256"];
  };
  EXPECT_EQ(digest("out/alone/summary.json"), digest("out/cases/000002/summary.json"));
  EXPECT_NE(digest("out/cases/000001/summary.json"), digest("out/cases/000002/summary.json"));
}

TEST_F(Sweep, runs_again_only_what_is_missing) {
  write(short_plan(), study_text("cases = 3,", speeds));
  ASSERT_EQ(sweep({}).exit_code, 0);
  const json before = equal_parts(folder_ / "out");
  const auto written = [&](int number) {
    return fs::last_write_time(folder_ /
                               ("out/cases/00000" + std::to_string(number) + "/case.json"));
  };
  const auto first = written(1), third = written(3);
  fs::remove_all(folder_ / "out/cases/000002");
  ASSERT_EQ(sweep({}).exit_code, 0);
  EXPECT_EQ(written(1), first);
  EXPECT_EQ(written(3), third);
  EXPECT_EQ(equal_parts(folder_ / "out"), before);
}

TEST_F(Sweep, keeps_its_cases_when_there_are_more) {
  write(short_plan(), study_text("cases = 2,", speeds));
  ASSERT_EQ(sweep({}).exit_code, 0);
  const json before = rows(folder_ / "out", "SELECT * FROM cases ORDER BY \"case\"");
  folder_.write("study.lua", study_text("cases = 3,", speeds));
  ASSERT_EQ(sweep({}).exit_code, 0);
  json after = rows(folder_ / "out", "SELECT * FROM cases ORDER BY \"case\"");
  ASSERT_EQ(after.size(), 3u);
  after.erase(2);
  EXPECT_EQ(after, before) << "to the time that they took: they have not run again";
}

TEST_F(Sweep, refuses_what_has_changed_by_name) {
  write(short_plan(), study_text("cases = 2, sampling = 'latin_hypercube',", speeds));
  ASSERT_EQ(sweep({}).exit_code, 0);
  const auto refusal = [&] {
    const Outcome outcome = sweep({});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  folder_.write("plan.kml", kml(short_plan({{"Heading", "90"}})));
  EXPECT_THAT(refusal(), HasSubstr("another state of the plan plan.kml: -o names a new folder"));
  folder_.write("plan.kml", kml(short_plan()));
  folder_.write("study.lua", study_text("cases = 3, sampling = 'latin_hypercube',", speeds));
  EXPECT_THAT(refusal(), HasSubstr("cases of the study, which are another Latin hypercube"));
  folder_.write("study.lua", study_text("cases = 2, sampling = 'random',", speeds));
  EXPECT_THAT(refusal(), HasSubstr("sampling of the study"));
  folder_.write("study.lua", study_text("cases = 2, sampling = 'latin_hypercube',", speeds));
  EXPECT_EQ(sweep({}).exit_code, 0) << "what was put back is what it was";
}

TEST_F(Sweep, tells_of_missions_that_fail) {
  write(short_plan(), study_text("sampling = 'grid', keep = 'failed',",
                                 "lsos.vary { of = 'Rover A.InitialCharge', list = { 0.9, 0 } },"));
  const Outcome outcome = sweep({});
  ASSERT_EQ(outcome.exit_code, 0) << "all cases have run: " << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 of 2 cases done (1 completed, 1 "));
  const json cases = rows(folder_ / "out", "SELECT * FROM cases ORDER BY \"case\"");
  EXPECT_EQ(cases[0]["status"], "completed");
  EXPECT_NE(cases[1]["status"], "completed");
  EXPECT_THAT(cases[1]["reason"].get<std::string>(), HasSubstr("A/10"));
  const json ends = all_rows(folder_ / "out", "ends");
  ASSERT_GE(ends.size(), 1u);
  EXPECT_EQ(ends[0]["case"], 2);
  EXPECT_TRUE(fs::exists(folder_ / "out/cases/000002/log.gpkg"));
  EXPECT_FALSE(fs::exists(folder_ / "out/cases/000001/log.gpkg"));
}

// The processes of a cluster's tasks find the record at once, each by its own name of the folder.
TEST_F(Sweep, leaves_its_record_as_it_is) {
  write(short_plan(), study_text("cases = 1, stop_when = lsos.stop_when { of = 'completed', within "
                                 "= 0.1 },",
                                 "lsos.vary { of = 'MissionInfo.Seed', list = { 1, 2 } },"));
  const Words run_words{"sweep", "run", "study.lua", "-o", "out", "--quiet"};
  ASSERT_EQ(run(run_words, {.folder = folder_.path()}).exit_code, 0);
  const std::string file = folder_ / "out/study.json";
  auto record = nlohmann::ordered_json::parse(read_text(file));
  record["last_case"] = 1;
  record["study_file"] = "/elsewhere/study.lua";
  const std::string text = record.dump();
  std::ofstream(file) << text;
  ASSERT_EQ(run(run_words, {.folder = folder_.path()}).exit_code, 0);
  EXPECT_EQ(read_text(file), text);
  // More cases are another matter.
  record["cases"] = 7;
  std::ofstream(file) << record.dump();
  ASSERT_EQ(run(run_words, {.folder = folder_.path()}).exit_code, 0);
  EXPECT_EQ(json::parse(read_text(file))["cases"], 1);
  EXPECT_EQ(json::parse(read_text(file))["last_case"], 1);
}

// As a Lustre that is mounted without them.
TEST_F(Sweep, says_where_the_file_system_has_no_locks) {
  if (is_sanitized) GTEST_SKIP() << "the sanitizer's library must come first";
  folder_.write("none.c",
                "#include <errno.h>\nint flock(int file, int how) { (void)file; (void)how; "
                "errno = ENOSYS; return -1; }\n");
  ASSERT_EQ(
      run_command({"cc", "-shared", "-fPIC", "-o", "none.so", "none.c"}, {.folder = folder_.path()})
          .exit_code,
      0);
  write(short_plan(), study_text("cases = 1,", speeds));
  const Outcome outcome = run({"sweep", "study.lua", "--quiet"},
                              {.folder = folder_.path(), .environment = {"LD_PRELOAD=./none.so"}});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("out/study: its file system has no locks (Function not "));
}

TEST_F(KilledSweep, at_a_few_moments_loses_nothing_and_repeats_nothing) { kill(3); }

TEST_F(Sweep, lists_its_cases_without_running_them) {
  write(short_plan(), study_text("cases = 3,", speeds));
  const Outcome outcome = sweep({"--dry-run", "-j", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("case 3: A/10.Speed = "));
  EXPECT_THAT(outcome.out, HasSubstr("3 cases, 1 at a time, would take about "));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  const json answer = json::parse(sweep({"--dry-run", "--json"}).out);
  ASSERT_EQ(answer["cases"].size(), 3u);
  EXPECT_GT(answer["case_wall_s"], 0);
}

TEST_F(Sweep, tells_all_faults_of_a_study_at_once) {
  write(short_plan(),
        study_text("cases = 2, gather = { lsos.gather { event = 'A/11', quantity = 'charge' } },",
                   "    lsos.vary { of = 'A/10.Sped', list = { 1 } },\n"
                   "    lsos.vary { of = 'A/10.Speed', uniform = { '-1 m/s', '2 m/s' } },\n"
                   "    lsos.vary { of = 'Rover A.battery.capacty_j', list = { 1e8 } },"));
  const Outcome outcome = sweep({});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("study.lua:6: vary 'A/10.Sped': Route has no field 'Sped'; "
                                     "did you mean 'Speed'?"));
  EXPECT_THAT(outcome.err, HasSubstr("study.lua:7: vary 'A/10.Speed': Speed = '-1 m/s': must be"));
  EXPECT_THAT(outcome.err, HasSubstr("gather: the plan has no event 'A/11'; did you mean"));
  EXPECT_THAT(outcome.err, HasSubstr("study.lua:8: vary 'Rover A.battery.capacty_j' = 100000000"));
  EXPECT_THAT(outcome.err, HasSubstr("capacity_j"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Sweep, gives_each_column_a_name_of_its_own) {
  write(
      short_plan(),
      study_text("cases = 1, gather = { lsos.gather { event = 'A/10', quantity = 'charge', name = "
                 "'Seed' }, lsos.gather { rover = 'A', take = 'least', quantity = 'charge', name "
                 "= 'a/10.speed' } },",
                 speeds));
  const Outcome outcome = sweep({});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("study.lua:4: gather: 'Seed' would be the column 'seed' of "));
  EXPECT_THAT(outcome.err, HasSubstr("gather: 'a/10.speed' would be the column 'A/10.Speed' of "));
  std::vector<Mark> marks = short_plan();
  marks.push_back(sev("a", "31.001,20"));
  write(marks, study_text("cases = 1,", speeds));
  EXPECT_THAT(sweep({}).err,
              HasSubstr("study: 'a_distance_m' would be the column 'A_distance_m' of study.gpkg, "
                        "whose names have no case: rovers"));
}

TEST_F(Sweep, refuses_forms_that_do_not_say_how) {
  write(short_plan(), study_text("cases = 2, sampling = 'grid',",
                                 "    lsos.vary { of = 'A/10.Speed' },\n"
                                 "    lsos.vary { of = 'A/10.Speed', list = {}, "
                                 "uniform = { 1, 2 } },\n"
                                 "    lsos.vary { of = 'A/10.Speed', normal = { mean = 1, "
                                 "deviaton = 1, min = 0, max = 2 } },"));
  const Outcome outcome = sweep({});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("study.lua:6: vary: 'A/10.Speed': no values are given"));
  EXPECT_THAT(outcome.err, HasSubstr("study.lua:7: vary: list: is empty"));
  EXPECT_THAT(outcome.err, HasSubstr("list and uniform are given"));
  EXPECT_THAT(outcome.err, HasSubstr("there is no key 'deviaton'; did you mean 'deviation'?"));
}

TEST_F(Sweep, of_a_new_study_runs) {
  folder_.write("plan.kml", kml(short_plan()));
  const Surroundings here{.folder = folder_.path()};
  const Outcome made = run({"new", "study", "plan.kml"}, here);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("try it: lsos-host sweep plan_study.lua"));
  const Outcome swept = run({"sweep", "plan_study.lua", "--quiet"}, here);
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  EXPECT_EQ(rows(folder_ / "out/plan_study", "SELECT * FROM cases").size(), 6u);
}

TEST_F(Sweep, says_which_words_it_takes) {
  write(short_plan(), study_text("cases = 2,", speeds));
  const auto refusal = [&](const Words& words) {
    const Outcome outcome = run(words, {.folder = folder_.path()});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refusal({"sweep", "run", "study.lua", "--cases", "2-9"}),
              HasSubstr("--cases 2-9: numbers from 1 to 2 are wanted"));
  EXPECT_THAT(refusal({"sweep", "status", "study.lua"}), HasSubstr("holds no study"));
  EXPECT_THAT(refusal({"sweep", "none.lua"}), HasSubstr("none.lua: cannot be read"));
  folder_.write("out/study/mine.txt", "x");
  EXPECT_THAT(refusal({"sweep", "study.lua"}), HasSubstr("these are never touched"));
}

}  // namespace
}  // namespace lsos::test
