// Runs that are stopped from outside, and their folders.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class StoppedRun : public ::testing::Test {
 protected:
  StoppedRun() : process_(program({plan_, "-o", run_})) {}

  void stop_with(int signal) {
    ASSERT_TRUE(wait_for_samples(process_, run_)) << process_.wait().err;
    process_.signal(signal);
    outcome_ = process_.wait();
  }

  TempFolder folder_;
  std::string plan_ = folder_.write("long.kml", kml(long_drive()));
  fs::path run_ = folder_ / "run";
  Process process_;
  Outcome outcome_;
};

TEST_F(StoppedRun, by_interrupt_writes_what_it_had) {
  stop_with(SIGINT);
  EXPECT_FALSE(outcome_.was_killed);
  EXPECT_EQ(outcome_.exit_code, 130) << outcome_.err;
  EXPECT_EQ(summary(run_)["status"], "incomplete");
  EXPECT_EQ(query(run_ / "log.gpkg", "select status from events"), "incomplete");
  EXPECT_TRUE(fs::exists(run_ / "overlay.kml"));
  EXPECT_FALSE(fs::exists(run_ / "log.gpkg-wal"));
}

TEST_F(StoppedRun, by_terminate_writes_what_it_had) {
  stop_with(SIGTERM);
  EXPECT_FALSE(outcome_.was_killed);
  EXPECT_EQ(outcome_.exit_code, 143) << outcome_.err;
  EXPECT_EQ(summary(run_)["status"], "incomplete");
}

TEST_F(StoppedRun, by_kill_leaves_a_log_that_others_read) {
  stop_with(SIGKILL);
  EXPECT_TRUE(outcome_.was_killed);
  const Outcome info = run_command({"ogrinfo", "-ro", "-al", "-so", run_ / "log.gpkg"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("Layer name: samples"));
  EXPECT_NE(query(run_ / "log.gpkg", "select count(*) from samples"), "0");
}

TEST_F(StoppedRun, by_kill_is_replaced_only_by_force) {
  stop_with(SIGKILL);
  folder_.write("long.kml", kml(short_drive()));
  const Outcome refused = run({plan_, "-o", run_});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_FALSE(fs::exists(run_ / "summary.json"));

  const Outcome forced = run({plan_, "-o", run_, "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_EQ(summary(run_)["status"], "completed");
}

TEST_F(StoppedRun, is_not_disturbed_by_a_second_writer_before_it_stops) {
  ASSERT_TRUE(wait_for_samples(process_, run_)) << process_.wait().err;
  const Outcome second = run({plan_, "-o", run_, "--force"});
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_TRUE(process_.is_running());
  process_.signal(SIGINT);
  EXPECT_EQ(process_.wait().exit_code, 130);
  EXPECT_EQ(summary(run_)["status"], "incomplete");
}

TEST(FinishedRun, is_replaced) {
  const TempFolder folder;
  const std::string first = digest_of(folder, short_drive());
  EXPECT_NE(digest_of(folder, two_rovers()), first);
  EXPECT_TRUE(summary(folder / "run")["rovers"].contains("North"));
}

TEST(FinishedRun, stays_when_the_new_plan_is_wrong) {
  const TempFolder folder;
  digest_of(folder, short_drive());
  const std::string before = read_text(folder / "run" / "summary.json");
  const std::string log = read_text(folder / "run" / "log.gpkg");
  const std::string plan = folder.write("wrong.kml", kml({mission()}) + "<");
  EXPECT_EQ(run({plan, "-o", folder / "run"}).exit_code, 2);
  EXPECT_EQ(read_text(folder / "run" / "summary.json"), before);
  EXPECT_EQ(read_text(folder / "run" / "log.gpkg"), log);
}

TEST(ForeignFolder, is_never_touched) {
  for (const Words& options : {Words{}, Words{"--force"}}) {
    const TempFolder folder;
    folder.write("home/log.gpkg", "a log of another program");
    folder.write("home/thesis.txt", "four years of work");
    Words arguments = {folder.write("plan.kml", kml(short_drive())), "-o", folder / "home"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(run(arguments).exit_code, 2);
    EXPECT_EQ(read_text(folder / "home" / "log.gpkg"), "a log of another program");
    EXPECT_EQ(read_text(folder / "home" / "thesis.txt"), "four years of work");
    const fs::directory_iterator files(folder / "home");
    EXPECT_EQ(std::distance(begin(files), end(files)), 2);
  }
}

TEST(OutputFolder, is_named_after_the_plan_by_default) {
  const TempFolder folder;
  folder.write("plans/short.kml", kml(short_drive()));
  const Outcome outcome = run({"plans/short.kml"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "out" / "short" / "summary.json"));
}

// A named pipe that nobody writes to blocks `check` while it reads.
TEST(StoppedCheck, ends_at_once) {
  const TempFolder folder;
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string file = folder / ("pipe" + std::to_string(signal) + ".kml");
    ASSERT_EQ(run_command({"mkfifo", file}).exit_code, 0);
    Process process(program({"check", file}));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ASSERT_TRUE(process.is_running()) << process.wait().out;
    process.signal(signal);
    for (int i = 0; i < 1000 && process.is_running(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_FALSE(process.is_running()) << "signal " << signal << " did not end it";
    EXPECT_EQ(process.wait().exit_code, 128 + signal);
  }
}

}  // namespace
}  // namespace lsos::test
