// Standard streams that are closed, and signals by which a user, a terminal or a batch system asks
// the program to stop.

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

// Runs a command line of a shell in which $P is the program.
Outcome in_shell(const std::string& line, const fs::path& folder) {
  return run_command({"bash", "-c", "P='" LSOS_PROGRAM "'; " + line}, {.folder = folder});
}

// The program with stop signals at their default effect, whatever the test inherited, save that
// one is ignored.
Words started(const Words& arguments, const std::string& ignored = "") {
  Words words{"env", "--default-signal=INT,TERM,HUP,XCPU"};
  if (!ignored.empty()) words.push_back("--ignore-signal=" + ignored);
  for (const std::string& word : program(arguments)) words.push_back(word);
  return words;
}

void wait_at_most(Process& process, std::chrono::milliseconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
  while (process.is_running() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

TEST(ClosedStreams, are_no_files_of_the_run) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(short_drive()));
  for (const char* closed : {"2>&-", "1>&- 2>&-", "0<&- 1>&- 2>&-"}) {
    in_shell("$P plan.kml -o run --no-report --force " + std::string(closed), folder.path());
    EXPECT_EQ(summary(folder / "run")["status"], "completed") << closed;
    EXPECT_EQ(read_text(folder / "run/plan.kml"), read_text(plan)) << closed;
    EXPECT_FALSE(fs::exists(folder / "run/.lsos-host.lock")) << closed;
    EXPECT_EQ(query(folder / "run/log.gpkg", "pragma integrity_check"), "ok") << closed;
  }
  folder.write("plan.kml", kml(long_drive()));
  Process process({"bash", "-c", "exec '" LSOS_PROGRAM "' plan.kml -o killed 0<&- 1>&- 2>&-"},
                  {.folder = folder.path()});
  ASSERT_TRUE(wait_for_samples(process, folder / "killed"));
  process.signal(SIGKILL);
  process.wait();
  EXPECT_EQ(read_text(folder / "killed/.lsos-host.lock"),
            "a run of lsos-host that has not finished\n");
}

class SignalledRun : public ::testing::Test {
 protected:
  // Starts hours of driving.
  Process& start(const std::string& ignored = "") {
    process_ = std::make_unique<Process>(started({plan_, "-o", run_}, ignored));
    EXPECT_TRUE(wait_for_samples(*process_, run_)) << process_->wait().err;
    return *process_;
  }

  TempFolder folder_;
  std::string plan_ = folder_.write("plan.kml", kml(long_drive()));
  fs::path run_ = folder_ / "run";
  std::unique_ptr<Process> process_;
};

TEST_F(SignalledRun, by_a_hangup_writes_what_it_had) {
  Process& process = start();
  process.signal(SIGHUP);
  const Outcome outcome = process.wait();
  EXPECT_FALSE(outcome.was_killed);
  EXPECT_EQ(outcome.exit_code, 128 + SIGHUP);
  EXPECT_THAT(outcome.err, HasSubstr("SIGHUP: stops; first the step under way ends, and the log is "
                                     "closed; a second SIGHUP ends it at once"));
  EXPECT_THAT(outcome.err, HasSubstr("resume with 'lsos-host resume"));
  EXPECT_EQ(summary(run_)["status"], "incomplete");
  EXPECT_THAT(query(run_ / "log.gpkg", "select reason from events"), HasSubstr("SIGHUP"));
}

TEST_F(SignalledRun, by_the_limit_of_cpu_time_writes_what_it_had) {
  const Outcome outcome = run_command(
      {"bash", "-c", "ulimit -S -t 3; exec \"$@\"", "bash", LSOS_PROGRAM, plan_, "-o", run_});
  EXPECT_EQ(outcome.exit_code, 128 + SIGXCPU) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("SIGXCPU, the limit of CPU time: stops; first "));
  EXPECT_EQ(summary(run_)["status"], "incomplete");
}

// As in the background of a shell script, or under nohup.
TEST_F(SignalledRun, goes_on_where_the_parent_ignores_the_signal) {
  for (const auto& [name, number] : {std::pair("INT", SIGINT), std::pair("HUP", SIGHUP)}) {
    fs::remove_all(run_);
    Process& process = start(name);
    process.signal(number);
    process.signal(number);
    wait_at_most(process, std::chrono::milliseconds(500));
    EXPECT_TRUE(process.is_running()) << name;
    process.signal(SIGTERM);
    EXPECT_EQ(process.wait().exit_code, 128 + SIGTERM) << name;
  }
}

TEST_F(SignalledRun, ends_soon) {
  Process& process = start();
  process.signal(SIGINT);
  wait_at_most(process, std::chrono::seconds(30));  // a second on an idle machine
  EXPECT_FALSE(process.is_running());
  EXPECT_EQ(process.wait().exit_code, 128 + SIGINT);
}

TEST_F(SignalledRun, ends_at_once_by_a_second_signal_and_can_go_on) {
  Process& process = start();
  process.signal(SIGINT);
  process.signal(SIGINT);
  process.wait();
  for (const auto& entry : fs::directory_iterator(run_)) {
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part"))) << "nothing half-written stays";
  }
  Process again(started({"resume", run_}));
  EXPECT_TRUE(wait_for_samples(again, run_));
  again.signal(SIGTERM);
  EXPECT_EQ(again.wait().exit_code, 128 + SIGTERM);
}

TEST_F(SignalledRun, of_watch_is_stopped_by_a_hangup) {
  Process process(started({"run", plan_, "-o", run_, "--watch"}));
  ASSERT_TRUE(wait_for_samples(process, run_)) << process.wait().err;
  process.signal(SIGHUP);
  EXPECT_EQ(process.wait().exit_code, 128 + SIGHUP);
  EXPECT_EQ(summary(run_)["status"], "incomplete");
}

// Its scenarios run in processes of their own.
TEST(SignalledTest, leaves_no_process_behind) {
  const TempFolder folder;
  folder.write("plan.kml", kml(long_drive()));
  folder.write("all.lua", R"(
local lsos = require 'lsos'
lsos.scenario('drives', function() lsos.sim('plan.kml'):run() end)
)");
  const Surroundings there{folder.path()};
  Process process(started({"test", "all.lua", "-o", "logs"}), there);
  ASSERT_TRUE(wait_for_samples(process, folder / "logs/all/drives/sim1")) << process.wait().err;
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait().exit_code, 128 + SIGTERM);
  folder.write("short.kml", kml(short_drive()));
  const Words next{"run", "short.kml", "-o", "logs/all/drives/sim1", "--force", "--no-report"};
  Outcome outcome;
  for (int tries = 0; tries < 20; ++tries) {
    outcome = run(next, there);
    if (outcome.exit_code == 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(outcome.exit_code, 0) << "a scenario still writes there: " << outcome.err;
}

// Stopped while the results of a mission that has ended are written.
TEST(SignalledReport, leaves_the_run_and_says_what_is_missing) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(two_rovers()));
  const fs::path run_dir = folder / "run";
  Process process(started({plan, "-o", run_dir}));
  while (!fs::exists(run_dir / "summary.json") && process.is_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 128 + SIGINT);
  EXPECT_THAT(outcome.err, HasSubstr("SIGINT: stops; first the log is closed, and the summary, the "
                                     "overlay and the report are written"));
  EXPECT_THAT(outcome.err,
              HasSubstr("report.html is missing: stopped by SIGINT; lsos-host report "));
  EXPECT_EQ(summary(run_dir)["status"], "completed");
  EXPECT_THAT(summary(run_dir)["warnings"].dump(), HasSubstr("report.html is missing: stopped"));
  EXPECT_FALSE(fs::exists(run_dir / "log.gpkg-wal"));
  EXPECT_EQ(run({"report", run_dir, "--no-pictures"}).exit_code, 0);
}

}  // namespace
}  // namespace lsos::test
