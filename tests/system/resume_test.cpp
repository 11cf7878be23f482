// Runs that are killed or stopped, and go on from their last checkpoint.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "system/killed_runs.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

void change(const std::string& log, const std::string& sql) {
  const Outcome outcome = run_command({"sqlite3", log, sql});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// Some seconds of computing, so that a run is still under way when its first rows are committed.
std::vector<Mark> many_minutes() {
  return {mission(), sev("SEV1", "0,0"),
          event("Route", "SEV1", 10, {{"Speed", "2"}}, line("0,0 0.03,0 0.03,0.03 0,0.03"))};
}

using Resume = KilledRuns;

TEST_F(Resume, ends_as_a_run_in_one_piece_wherever_it_was_killed) {
  whole_run(two_rovers());
  kill_and_resume(10);
}

// Stopped runs, and what is said of them.
class StopAndResume : public KilledRuns {
 protected:
  StopAndResume() : run_(folder_ / "run") {}

  Outcome stop(int signal, const Words& more = {}) {
    plan_ = folder_.write("plan.kml", kml(long_drive()));
    Process process(program(with({plan_, "-o", run_, "--no-report"}, more)));
    EXPECT_TRUE(wait_for_samples(process, run_));
    process.signal(signal);
    return process.wait();
  }

  std::string refusal(const Words& more = {}) {
    const Outcome outcome = run(with({"resume", run_}, more));
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    return outcome.err;
  }

  std::string run_;
};

TEST_F(StopAndResume, says_how_to_go_on) {
  const Outcome outcome = stop(SIGINT);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_THAT(outcome.err, EndsWith("resume with 'lsos-host resume " + run_ + "'\n"));
  const Outcome again = run({plan_, "-o", run_});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("'lsos-host resume " + run_ + "' goes on with it"));
  EXPECT_TRUE(fs::exists(run_ + "/summary.json"));
}

TEST_F(StopAndResume, says_so_of_a_killed_run_too) {
  stop(SIGKILL);
  const Outcome again = run({plan_, "-o", run_});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("'lsos-host resume " + run_ + "' goes on with it"));
}

TEST_F(StopAndResume, goes_on_after_an_interrupt_without_a_trace_of_it) {
  whole_run(many_minutes());
  Process process(program(with({plan_, "-o", run_}, dense)));
  ASSERT_TRUE(wait_for_samples(process, run_));
  process.signal(SIGTERM);
  ASSERT_EQ(process.wait().exit_code, 143);
  EXPECT_EQ(summary(run_)["status"], "incomplete");
  const Outcome resumed = run({"resume", run_, "--no-report"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(summary(run_)["log_sha256"], digest_);
}

TEST_F(StopAndResume, refuses_a_finished_run) {
  whole_run(short_drive());
  run_ = folder_ / "whole";
  EXPECT_THAT(refusal(), HasSubstr("its run has finished"));
  EXPECT_EQ(summary(run_)["log_sha256"], digest_) << "nothing is lost";
}

TEST_F(StopAndResume, refuses_a_run_without_checkpoints) {
  stop(SIGKILL, {"--no-checkpoints"});
  EXPECT_THAT(refusal(), HasSubstr("has no checkpoint"));
}

TEST_F(StopAndResume, refuses_another_plan) {
  stop(SIGKILL);
  std::vector<Mark> other = long_drive();
  other.back().fields.push_back({"Timeout", "10 d"});
  folder_.write("run/plan.kml", kml(other));
  EXPECT_THAT(refusal(), HasSubstr("the plan is not what was run"));
}

TEST_F(StopAndResume, is_not_troubled_by_a_plan_that_was_edited) {
  whole_run(many_minutes());
  Process process(program(with({plan_, "-o", run_}, dense)));
  ASSERT_TRUE(wait_for_samples(process, run_));
  process.signal(SIGKILL);
  ASSERT_TRUE(process.wait().was_killed);
  folder_.write("plan.kml", kml(short_drive()));
  const Outcome resumed = run({"resume", run_, "--no-report"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.err, HasSubstr(plan_ + ": has changed since it was run; the run goes on"));
  EXPECT_EQ(summary(run_)["log_sha256"], digest_);
}

TEST_F(StopAndResume, refuses_another_renderer_unless_allowed) {
  whole_run(many_minutes());
  const std::string first =
      query(folder_ / "whole/log.gpkg", "select value from run where key = 'renderer'");
  Process process(program(with({plan_, "-o", run_}, dense)));
  ASSERT_TRUE(wait_for_samples(process, run_));
  process.signal(SIGKILL);
  process.wait();
  const Surroundings softpipe{.environment = {"GALLIUM_DRIVER=softpipe"}};
  const Outcome refused = run({"resume", run_, "--no-report"}, softpipe);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("light and sight were drawn by " + first));
  EXPECT_THAT(refused.err, HasSubstr("--allow-renderer goes on nevertheless"));
  EXPECT_EQ(run({"resume", run_, "--no-report", "--allow-renderer"}, softpipe).exit_code, 0);
  const std::string then =
      query(run_ + "/log.gpkg", "select value from run where key = 'renderer'");
  EXPECT_THAT(then, HasSubstr(first + ", from "));
  EXPECT_THAT(then, HasSubstr(" s on "));
}

TEST_F(StopAndResume, refuses_a_changed_script_by_name) {
  folder_.write("rovers/SEV.lua", read_text(repository() / "rovers/SEV.lua"));
  stop(SIGKILL);
  folder_.write("rovers/SEV.lua", read_text(repository() / "rovers/SEV.lua") + "-- changed\n");
  EXPECT_THAT(refusal(), HasSubstr("the rover script SEV is not what was run"));
}

TEST_F(StopAndResume, passes_over_a_damaged_checkpoint) {
  stop(SIGKILL, {"--checkpoint-every", "2 s"});
  const std::string log = run_ + "/log.gpkg";
  // One more than the kill has left, which may be that of the start alone.
  change(log,
         "insert into lsos_checkpoints (time_us, kind, sha256, content) select time_us, kind, "
         "sha256, zeroblob(1000) from lsos_checkpoints order by id desc limit 1");
  Process process(program({"resume", run_, "--no-report"}));
  for (int k = 0; k < 12000 && process.is_running(); ++k) {
    if (process.err_so_far().find("goes on at") != std::string::npos) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_THAT(process.err_so_far(), HasSubstr("is damaged"));
  EXPECT_THAT(process.err_so_far(), HasSubstr("goes on at"));
  process.signal(SIGKILL);
  process.wait();
  change(log, "update lsos_checkpoints set sha256 = 'no'");
  EXPECT_THAT(refusal(), HasSubstr("none of its checkpoints can be read"));
}

TEST_F(StopAndResume, refuses_what_holds_no_run) {
  fs::create_directory(run_);
  EXPECT_THAT(refusal(), HasSubstr("holds no run of lsos-host"));
  run_ += "/nowhere";
  EXPECT_THAT(refusal(), HasSubstr("no such folder"));
  EXPECT_FALSE(fs::exists(run_));
}

TEST(Checkpoints, do_not_change_the_digest_and_stay_only_when_kept) {
  const TempFolder folder;
  const std::string none = digest_of(folder, two_rovers(), {"--no-checkpoints"});
  EXPECT_EQ(
      query(folder / "run/log.gpkg", "select count(*) from sqlite_master where name like 'lsos%'"),
      "0");
  EXPECT_EQ(digest_of(folder, two_rovers(), {"--checkpoint-every", "30 s"}), none);
  const std::string log = folder / "run/log.gpkg";
  EXPECT_EQ(query(log, "select count(distinct kind) from lsos_checkpoints"), "1");
  EXPECT_GE(std::stoi(query(log, "select count(*) from lsos_checkpoints where kind = 'kept'")), 3);
  EXPECT_LT(std::stoi(query(log, "select max(length(content)) from lsos_checkpoints")), 1'000'000);
  const Outcome info = run_command({"ogrinfo", "-ro", log});
  EXPECT_THAT(info.out, Not(HasSubstr("lsos_checkpoints"))) << "it is no layer";
}

TEST(Checkpoints, are_kept_at_durations_that_make_sense) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  const auto refusal = [&](const Words& words) {
    const Outcome outcome = run(with({plan, "-o", folder / "run"}, words));
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(refusal({"--checkpoint-every", "0.1 s"}), HasSubstr("1 s to 1e+09 s are allowed"));
  EXPECT_THAT(refusal({"--checkpoint-every", "daily"}), HasSubstr("--checkpoint-every daily"));
  EXPECT_THAT(refusal({"--checkpoint-every", "1 d", "--no-checkpoints"}),
              HasSubstr("--no-checkpoints writes none"));
}

}  // namespace
}  // namespace lsos::test
