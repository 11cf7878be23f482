// Runs that are killed or stopped, and go on from their last checkpoint.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using Clock = std::chrono::steady_clock;

void change(const std::string& log, const std::string& sql) {
  const Outcome outcome = run_command({"sqlite3", log, sql});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// Many checkpoints, and so many commits, that a kill often falls into one.
const Words dense = {"--checkpoint-every", "2 s", "--no-report", "--quiet"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Some seconds of computing, so that a run is still under way when its first rows are committed.
std::vector<Mark> many_minutes() {
  return {mission(), sev("SEV1", "0,0"),
          event("Route", "SEV1", 10, {{"Speed", "2"}}, line("0,0 0.03,0 0.03,0.03 0,0.03"))};
}

// A plan, and the digest of its run in one piece.
class Resume : public ::testing::Test {
 protected:
  void whole_run(const std::vector<Mark>& marks) {
    plan_ = folder_.write("plan.kml", kml(marks));
    const auto begin = Clock::now();
    const Outcome outcome = run(with({plan_, "-o", folder_ / "whole"}, dense));
    ASSERT_LE(outcome.exit_code, 1) << outcome.err;
    took_s_ = std::chrono::duration<double>(Clock::now() - begin).count();
    digest_ = summary(folder_ / "whole")["log_sha256"];
  }

  // Starts a run and kills it after this time. False when it had ended by itself.
  bool kill_after(const Words& words, double after_s) {
    Process process(program(words));
    const auto begin = Clock::now();
    while (std::chrono::duration<double>(Clock::now() - begin).count() < after_s) {
      if (!process.is_running()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    process.signal(SIGKILL);
    return process.wait().was_killed;
  }

  // Kills a run, resumes it, kills that too, and resumes it to its end. The time that a run takes
  // is learnt on the way, as the machine may be busier than it was during the whole run.
  void kill_and_resume(std::mt19937& random) {
    const fs::path run_folder = folder_ / "run";
    fs::remove_all(run_folder);
    std::uniform_real_distribution<double> share(0.15, 0.95);
    if (!kill_after(with({plan_, "-o", run_folder}, dense), share(random) * took_s_)) {
      took_s_ *= 0.7;
      return;
    }
    if (!fs::exists(run_folder / "log.gpkg")) {
      took_s_ *= 1.3;
      return;
    }
    if (query(run_folder / "log.gpkg",
              "select count(*) from sqlite_master where name = "
              "'lsos_checkpoints'") != "1") {
      EXPECT_EQ(run({"resume", run_folder}).exit_code, 2) << "before its first checkpoint";
      took_s_ *= 1.3;
      return;
    }
    const std::string threads = std::to_string(1 + random() % 3);
    const Words resume = {"resume", run_folder, "--no-report", "--quiet", "--threads", threads};
    kill_after(resume, share(random) * took_s_);
    ++kills_;
    if (fs::exists(run_folder / "summary.json")) {  // it had ended
      EXPECT_EQ(summary(run_folder)["log_sha256"], digest_);
      return;
    }
    const Outcome outcome = run(resume);
    EXPECT_LE(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(summary(run_folder)["log_sha256"], digest_);
    EXPECT_EQ(summary(run_folder)["events"], summary(folder_ / "whole")["events"]);
    EXPECT_EQ(summary(run_folder)["warnings"], summary(folder_ / "whole")["warnings"]);
  }

  TempFolder folder_;
  std::string plan_, digest_;
  double took_s_ = 0;
  int kills_ = 0;
};

TEST_F(Resume, ends_as_a_run_in_one_piece_wherever_it_was_killed) {
  whole_run(two_rovers());
  std::mt19937 random(1);
  for (int k = 0; k < 100 && kills_ < 10 && !HasFailure(); ++k) kill_and_resume(random);
  EXPECT_EQ(kills_, 10);
}

// Stopped runs, and what is said of them.
class StopAndResume : public Resume {
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
  change(log,
         "update lsos_checkpoints set content = zeroblob(1000) where id = (select max(id) from "
         "lsos_checkpoints)");
  Process process(program({"resume", run_, "--no-report"}));
  for (int k = 0; k < 1000 && process.is_running(); ++k) {
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
