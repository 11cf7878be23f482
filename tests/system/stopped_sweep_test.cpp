// Sweeps that are told to stop, by a terminal or a batch system.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "system/study_text.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

class StoppedSweep : public ::testing::Test {
 protected:
  void write(const std::vector<Mark>& marks, const std::string& study) {
    folder_.write("plan.kml", kml(marks));
    folder_.write("study.lua", study);
  }

  // Whether a process has a handler for a signal.
  static bool heeds(pid_t process, int signal) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with("SigCgt:")) continue;
      return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
    }
    return false;
  }

  // Waits until the first case drives.
  void wait_for_drive() const {
    const fs::path log = folder_ / "out/cases/000001.part/log.gpkg";
    for (int i = 0; i < 1000 && !fs::exists(log); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
  }

  static void pause_ms(int time) { std::this_thread::sleep_for(std::chrono::milliseconds(time)); }

  TempFolder folder_;
};

TEST_F(StoppedSweep, goes_on_after_it_was_stopped) {
  write(long_drive(), study_text("cases = 2, keep = 'all',",
                                 "lsos.vary { of = 'MissionInfo.Seed', list = { 1, 2 } },"));
  Process sweeping(program({"sweep", "study.lua", "-o", "out", "-j", "2", "--quiet"}),
                   {.folder = folder_.path()});
  wait_for_drive();
  sweeping.signal(SIGTERM);
  const Outcome stopped = sweeping.wait();
  EXPECT_EQ(stopped.exit_code, 143) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("stopped: the same command goes on"));
  const json part = json::parse(read_text(folder_ / "out/cases/000001.part/summary.json"));
  EXPECT_EQ(part["status"], "incomplete");
  EXPECT_GT(part["sim_s"], 0) << "it stopped at a checkpoint";
  const Outcome status =
      run({"sweep", "status", "study.lua", "-o", "out", "--json"}, {.folder = folder_.path()});
  const json state = json::parse(status.out);
  EXPECT_EQ(state["cases"], 2);
  EXPECT_EQ(state["done"], 0);
  EXPECT_EQ(state["running"], json::array());
}

// What runs a task again where it was stopped would never end.
TEST_F(StoppedSweep, tells_when_it_was_stopped_before_a_case_came_further) {
  write(long_drive(),
        study_text("cases = 1,", "lsos.vary { of = 'MissionInfo.Seed', list = { 1, 2 } },"));
  const Words words = program({"sweep", "run", "study.lua", "-o", "out", "--quiet"});
  Process early(words, {.folder = folder_.path()});
  // From its first steps on it heeds the signal.
  for (int i = 0; i < 1000 && !heeds(early.id(), SIGTERM); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  early.signal(SIGTERM);
  const Outcome none = early.wait();
  EXPECT_EQ(none.exit_code, 75) << none.err;
  EXPECT_THAT(none.err, HasSubstr("stopped before any case came further than before"));

  Process later(words, {.folder = folder_.path()});
  wait_for_drive();
  later.signal(SIGTERM);
  const Outcome further = later.wait();
  EXPECT_EQ(further.exit_code, 143) << further.err;
  EXPECT_THAT(further.err, HasSubstr("stopped: the same command goes on"));
}

// A batch system sends SIGTERM to all processes of a job, and the job's shell passes on its own.
TEST_F(StoppedSweep, stops_at_a_checkpoint_however_often_it_is_told) {
  write(long_drive(),
        study_text("cases = 1,", "lsos.vary { of = 'MissionInfo.Seed', list = { 1, 2 } },"));
  Process sweeping(program({"sweep", "study.lua", "-o", "out", "--quiet"}),
                   {.folder = folder_.path()});
  wait_for_drive();
  const std::string id = std::to_string(sweeping.id());
  std::ifstream children("/proc/" + id + "/task/" + id + "/children");
  pid_t child = 0;
  ASSERT_TRUE(children >> child);
  kill(child, SIGTERM);
  sweeping.signal(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  sweeping.signal(SIGTERM);
  const Outcome stopped = sweeping.wait();
  EXPECT_FALSE(stopped.was_killed);
  EXPECT_EQ(stopped.exit_code, 143) << stopped.err;
  const json part = json::parse(read_text(folder_ / "out/cases/000001.part/summary.json"));
  EXPECT_GT(part["sim_s"], 0) << "it stopped at a checkpoint";
}

// A case that another process has is waited for, but no longer than the task may.
TEST_F(StoppedSweep, does_not_wait_for_others) {
  write(long_drive(),
        study_text("cases = 1,", "lsos.vary { of = 'MissionInfo.Seed', list = { 1, 2 } },"));
  const std::string lock = folder_ / "out/cases/000001.lock";
  fs::create_directories(folder_ / "out/cases");
  Process other({"flock", lock, "sleep", "60"});
  for (int i = 0; i < 1000 && !fs::exists(lock); ++i) pause_ms(10);
  Process sweeping(program({"sweep", "run", "study.lua", "-o", "out", "--quiet"}),
                   {.folder = folder_.path()});
  const std::string id = std::to_string(sweeping.id());
  pid_t child = 0;
  for (int i = 0; i < 1000 && !heeds(child, SIGHUP); ++i) {
    pause_ms(10);
    std::ifstream("/proc/" + id + "/task/" + id + "/children") >> child;
  }
  const auto begin = std::chrono::steady_clock::now();
  sweeping.signal(SIGTERM);
  EXPECT_EQ(sweeping.wait().exit_code, 75);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  EXPECT_FALSE(fs::exists(folder_ / "out/cases/000001.part"));
}

}  // namespace
}  // namespace lsos::test
