// Results that cannot be written: the program never claims them, and loses no run for lack of one.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "support/sanitizer.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

// Runs the program in a shell, with text such as a redirection appended to its command line.
Outcome in_shell(const Words& arguments, const std::string& suffix, const fs::path& folder = ".") {
  std::string line = "'" LSOS_PROGRAM "'";
  for (const std::string& word : arguments) line += " '" + word + "'";
  return run_command({"bash", "-c", line + " " + suffix}, {.folder = folder});
}

// Words that run the program as a user without rights on the files.
Words as_other_user(const Words& arguments) {
  if (geteuid() != 0) return program(arguments);  // read-only folders are enough
  Words words{"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
  for (const std::string& word : program(arguments)) words.push_back(word);
  return words;
}

class OtherUser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (run_command(as_other_user({"--version"})).exit_code != 0) {
      GTEST_SKIP() << "no other user can run the program here";
    }
    fs::permissions(folder_.path(), fs::perms(0755));
    plan_ = folder_.write("plan.kml", kml(short_drive()));
  }
  void TearDown() override {
    fs::permissions(folder_.path(), fs::perms(0755));
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      if (entry.is_directory()) fs::permissions(entry.path(), fs::perms(0755));
    }
  }
  Outcome run_as_other_user(const Words& arguments) const {
    // The time limit ends an endless loop.
    Words words{"timeout", "60"};
    for (const std::string& word : as_other_user(arguments)) words.push_back(word);
    return run_command(words, {.folder = folder_.path()});
  }
  fs::path closed_folder(const std::string& name) const {
    fs::create_directory(folder_ / name);
    fs::permissions(folder_ / name, fs::perms(0555));
    return folder_ / name;
  }
  void close_all() const { fs::permissions(folder_.path(), fs::perms(0555)); }

  TempFolder folder_;
  std::string plan_;
};

TEST_F(OtherUser, is_told_that_a_run_cannot_be_written_there) {
  const fs::path closed = closed_folder("closed");
  close_all();
  for (const std::string& out : {closed.string(), (closed / "a/b").string(), std::string()}) {
    Words arguments{"run", plan_, "--quiet", "--no-report"};
    if (!out.empty()) arguments.insert(arguments.end(), {"-o", out});  // default: out/plan
    const Outcome outcome = run_as_other_user(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << out << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("Permission denied; name another folder with -o"));
  }
  EXPECT_TRUE(fs::is_empty(closed));
}

// The run's lock can be taken, but its files cannot be removed.
TEST_F(OtherUser, does_not_break_a_run_that_cannot_be_replaced) {
  ASSERT_EQ(run({"run", plan_, "-o", folder_ / "a", "--quiet", "--no-report"}).exit_code, 0);
  const std::string before = read_text(folder_ / "a" / "summary.json");
  folder_.write("a/.lsos-host.lock", "");
  fs::permissions(folder_ / "a/.lsos-host.lock", fs::perms(0666));
  fs::permissions(folder_ / "a", fs::perms(0555));
  const Outcome outcome =
      run_as_other_user({"run", plan_, "-o", folder_ / "a", "--quiet", "--no-report"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("cannot be written: Permission denied"));
  EXPECT_EQ(read_text(folder_ / "a" / "summary.json"), before);
  EXPECT_EQ(read_text(folder_ / "a" / ".lsos-host.lock"), "");
}

TEST_F(OtherUser, is_told_which_output_cannot_be_written) {
  ASSERT_EQ(run({"run", plan_, "-o", folder_ / "a", "--quiet", "--no-report"}).exit_code, 0);
  const fs::path closed = closed_folder("closed");
  fs::permissions(folder_ / "a", fs::perms(0555));
  const std::vector<Words> commands{
      {"overlay", folder_ / "a"},
      {"report", folder_ / "a", "--no-pictures"},
      {"report", folder_ / "a", "--png"},
      {"picture", folder_ / "a", "--at", "10", "-o", closed / "x.png"},
      {"terrain", "Flat", "--export", closed / "x.tif", "--window", "0,0,0.001,0.001",
       "--resolution", "5"},
      {"light", "Flat", "--at", "2026-07-01", "-o", closed / "x.tif", "--window", "0,0,0.001,0.001",
       "--resolution", "5"},
      {"sight", "Flat", "--from", "0,0,2", "--height", "1", "-o", closed / "x.tif", "--window",
       "0,0,0.001,0.001", "--resolution", "5"}};
  for (const Words& words : commands) {
    const Outcome outcome = run_as_other_user(words);
    EXPECT_EQ(outcome.exit_code, 2) << words[0] << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("Permission denied")) << words[0];
  }
  EXPECT_EQ(run_as_other_user({"compare", folder_ / "a", folder_ / "a"}).exit_code, 0)
      << "it writes nothing";
}

TEST_F(OtherUser, is_told_what_cannot_be_read) {
  ASSERT_EQ(run({"run", plan_, "-o", folder_ / "a", "--quiet", "--no-report"}).exit_code, 0);
  fs::permissions(folder_ / "a", fs::perms(0));
  for (const Words& words :
       {Words{"report", folder_ / "a"}, Words{"overlay", folder_ / "a"},
        Words{"compare", folder_ / "a", folder_ / "a"}, Words{"verify", folder_ / "a"},
        Words{"check", folder_ / "a/plan.kml"}, Words{"run", plan_, "-o", folder_ / "a"}}) {
    const Outcome outcome = run_as_other_user(words);
    EXPECT_EQ(outcome.exit_code, 2) << words[0] << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("fault inside the program")));
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr((folder_ / "a").string())) << words[0];
  }
}

TEST_F(OtherUser, is_warned_that_planned_routes_are_not_kept) {
  folder_.write("plan.kml",
                kml({mission(), sev("A", "31.0,20.0"),
                     event("PathPlanRoute", "A", 10, {}, line("31.0,20.0 31.0005,20.0"))}));
  close_all();
  const Outcome outcome = run_as_other_user({"check", plan_, "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("warning: planned routes are not kept for the next run: "));
  EXPECT_THAT(outcome.out, HasSubstr("plan.kml.routes: Permission denied"));
}

TEST(LostOutput, is_not_exit_0) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  const std::string run_dir = folder / "run";
  ASSERT_EQ(run({plan, "-o", run_dir, "--quiet", "--no-report"}).exit_code, 0);
  const std::vector<Words> commands{
      {"list", "events"},
      {"list", "rovers", "--json"},
      {"schema"},
      {"fsm", plan},
      {"check", plan},
      {"--help"},
      {"--version"},
      {"compare", run_dir, run_dir},
      {"verify", run_dir},
      {"overlay", run_dir},
      {"sun", "--planet", "Moon", "--site", "0,0", "--at", "2026-07-01"},
      {"terrain", "Flat", "--at", "31,20"},
      {"rig", "--soil", "ApolloNominal", "--radius", "0.3", "--width", "0.2", "--load", "300",
       "--slip", "0.2"}};
  for (const Words& words : commands) {
    const Outcome full = in_shell(words, "> /dev/full");
    EXPECT_EQ(full.exit_code, 3) << words[0];
    EXPECT_THAT(full.err, HasSubstr("standard output: the result is not whole: ")) << words[0];
  }
  const Outcome closed = in_shell({"list", "events"}, ">&-");
  EXPECT_EQ(closed.exit_code, 3) << closed.err;
  // The reader of the pipe has ended before the program writes.
  const Outcome broken = run_command({"bash", "-c",
                                      "{ sleep 0.3; '" LSOS_PROGRAM
                                      "' list events; echo code $? >&2; } | true; wait"});
  EXPECT_THAT(broken.err, HasSubstr("Broken pipe"));
  EXPECT_THAT(broken.err, HasSubstr("code 3"));
}

TEST(LostOutput, of_a_run_leaves_its_files) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  const Outcome outcome =
      in_shell({plan, "-o", folder / "run", "--quiet", "--no-report"}, "> /dev/full");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(summary(folder / "run")["status"], "completed");
}

TEST(LostMessages, stop_nothing) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  for (const char* suffix : {"2> /dev/full", "2>&-"}) {
    const Outcome done = in_shell({plan, "-o", folder / "run", "--no-report"}, suffix);
    EXPECT_EQ(done.exit_code, 0) << suffix;
    EXPECT_EQ(summary(folder / "run")["status"], "completed");
    EXPECT_EQ(in_shell({"run", folder / "none.kml"}, suffix).exit_code, 2) << suffix;
    EXPECT_EQ(in_shell({"list", "evnts"}, suffix).exit_code, 2) << suffix;
  }
}

// A limit on file sizes simulates a full disk: writes beyond it fail.
class FullDisk : public ::testing::TestWithParam<int> {};

TEST_P(FullDisk, ends_a_run_with_what_was_committed) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(long_drive()));
  const Outcome outcome = run_command(
      {"bash", "-c",
       "ulimit -f " + std::to_string(GetParam()) + "; exec timeout 100 '" LSOS_PROGRAM "' '" +
           plan + "' -o '" + (folder / "run").string() + "' --quiet --no-report"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("fault inside")));
  EXPECT_THAT(outcome.err, HasSubstr("log.gpkg"));
  EXPECT_FALSE(fs::exists(folder / "run" / "summary.json"));
  EXPECT_NE(query(folder / "run" / "log.gpkg", "select count(*) from samples"), "");
  // A later run may replace the folder.
  EXPECT_EQ(run({"run", folder.write("plan.kml", kml(short_drive())), "-o", folder / "run",
                 "--quiet", "--no-report", "--force"})
                .exit_code,
            0);
}

// The limit, in blocks of 1024 bytes, is reached some time after the layers are created.
INSTANTIATE_TEST_SUITE_P(Blocks, FullDisk, ::testing::Values(600));

// An event that logs ten notes per exchange.
TEST(ManyNotes, are_thinned_in_overlay_and_report) {
  const TempFolder folder;
  folder.write("events/Chatter.lua", R"(
local lsos = require 'lsos'
local function talk(ev, rover)
  for _ = 1, 10 do ev:log('chatter', { said = 'again' }) end
  if ev.phase_elapsed_s >= 60 then ev:log('silence', {}) return lsos.done end
end
return lsos.event {
  api = 1, schema = 'Chatter', doc = 'Talks.', params = {}, start = 'talk',
  phases = { talk = talk },
}
)");
  const std::string plan =
      folder.write("plan.kml", kml({mission(), sev("A", "31.0,20.0"), event("Chatter", "A", 10)}));
  const Outcome outcome = run({plan, "-o", folder / "run", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(query(folder / "run" / "log.gpkg", "select count(*) from notes"), "6011");
  const std::string overlay = read_text(folder / "run" / "overlay.kml");
  EXPECT_THAT(overlay, HasSubstr("<name>notes (2000 of 6011)</name>"));
  EXPECT_THAT(overlay, HasSubstr("<name>silence</name>"));
  EXPECT_THAT(read_text(folder / "run" / "report.html"), HasSubstr("\"notes_in_log\":6011"));
}

// A run completes even when its overlay and report cannot be written.
TEST(Products, that_cannot_be_made_are_warned_of) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  Process process(program({plan, "-o", folder / "run", "--quiet"}));
  fs::create_directories(folder / "run");
  // The names must be free until the log is created.
  while (!fs::exists(folder / "run" / "log.gpkg") && process.is_running()) usleep(1000);
  fs::create_directories(folder / "run" / "overlay.kml" / "in the way");
  fs::create_directories(folder / "run" / "report.html" / "in the way");
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* product : {"overlay", "report"}) {
    EXPECT_THAT(outcome.err, HasSubstr(std::string("; lsos-host ") + product));
  }
  EXPECT_THAT(outcome.err, HasSubstr("overlay.kml is missing: "));
  EXPECT_EQ(summary(folder / "run")["status"], "completed");
  EXPECT_THAT(summary(folder / "run")["warnings"].dump(), HasSubstr("overlay.kml is missing"));
  EXPECT_THAT(summary(folder / "run")["warnings"].dump(), HasSubstr("report.html is missing"));
}

void change(const fs::path& database, const std::string& sql) {
  const Outcome outcome = run_command({"sqlite3", database, sql});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(RunWithoutSamples, has_nothing_to_show) {
  const PlanRun plan_run(short_drive());
  const fs::path run_dir = plan_run.folder / "run";
  change(run_dir / "log.gpkg", "delete from samples");
  fs::remove(run_dir / "summary.json");
  for (const Words& words : {Words{"report"}, Words{"report", "--png"}, Words{"overlay"},
                             Words{"picture", "--at", "0", "-o", plan_run.folder / "x.png"}}) {
    Words arguments = words;
    arguments.insert(arguments.begin() + 1, run_dir);
    // The address sanitizer reserves terabytes of addresses itself.
    std::string line = is_sanitized ? "exec " : "ulimit -v 4000000; exec ";
    line += "'" LSOS_PROGRAM "'";
    for (const std::string& word : arguments) line += " '" + word + "'";
    const Outcome outcome = run_command({"bash", "-c", line});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("its log has no sample")) << words[0];
  }
}

TEST(ChangedLog, is_found_by_compare_and_verify) {
  const PlanRun a(short_drive()), b(short_drive());
  const std::string run_a = a.folder / "run", run_b = b.folder / "run";
  EXPECT_EQ(run({"compare", run_a, run_b}).exit_code, 0);
  const Outcome right = run({"verify", run_a, run_b});
  EXPECT_EQ(right.exit_code, 0) << right.err;
  EXPECT_THAT(right.out, HasSubstr(a.summary()["log_sha256"].get<std::string>()));

  change(fs::path(run_b) / "log.gpkg", "update samples set slope_rad = 0.5 where fid = 3");
  const Outcome changed = run({"verify", run_a, run_b});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_THAT(changed.out, HasSubstr("log.gpkg is as summary.json says"));
  EXPECT_THAT(changed.out,
              HasSubstr(run_b + ": log.gpkg is not the log that summary.json was written of"));
  const Outcome compared = run({"compare", run_a, run_b});
  EXPECT_EQ(compared.exit_code, 1);
  EXPECT_THAT(compared.out, HasSubstr("B: log.gpkg is not the log"));
  const auto json = nlohmann::json::parse(run({"verify", run_b, "--json"}).out);
  EXPECT_EQ(json[0]["is_verified"], false);
  EXPECT_EQ(run({"verify", a.folder / "none"}).exit_code, 2);
}

}  // namespace
}  // namespace lsos::test
