// Sweeps whose processes are killed or stopped at random moments, against one that was not.
#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <thread>

#include "system/study_text.h"

namespace lsos::test {

class KilledSweep : public ::testing::Test {
 protected:
  static constexpr int cases = 6;

  void SetUp() override {
    folder_.write("plan.kml", kml(short_plan()));
    folder_.write(
        "study.lua",
        study_text("cases = 6, sampling = 'sobol',",
                   "lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' } }"));
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(run_command(sweep("whole"), {.folder = folder_.path()}).exit_code, 0);
    took_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    whole_ = equal_parts(folder_ / "whole");
  }

  // Kills or stops a sweep, or kills one of its cases, at `count` random moments; each sweep goes
  // on in the folder of the one before until it is whole, and then another begins.
  void kill(int count) {
    std::string name = "killed";
    for (int i = 0; i < count; ++i) {
      const auto done_before = finished(name);
      const bool is_whole = kill_once(name);
      for (const auto& [number, written] : done_before) {
        EXPECT_EQ(finished(name)[number], written) << "case " << number << " was run again";
      }
      if (!is_whole) continue;
      EXPECT_EQ(equal_parts(folder_ / name), whole_) << name;
      name = "killed" + std::to_string(i);
    }
    ASSERT_EQ(run_command(sweep(name), {.folder = folder_.path()}).exit_code, 0);
    EXPECT_EQ(equal_parts(folder_ / name), whole_);
  }

 private:
  static Words sweep(const std::string& out) {
    return program({"sweep", "study.lua", "-o", out, "-j", "2", "--quiet"});
  }

  // When each finished case was written.
  std::map<int, std::filesystem::file_time_type> finished(const std::string& name) const {
    std::map<int, std::filesystem::file_time_type> written;
    for (int number = 1; number <= cases; ++number) {
      const auto file = folder_ / (name + "/cases/00000" + std::to_string(number) + "/case.json");
      std::error_code absent;
      const auto time = std::filesystem::last_write_time(file, absent);
      if (!absent) written[number] = time;
    }
    return written;
  }

  // Whether the sweep came to its end before it was killed.
  bool kill_once(const std::string& name) {
    Process sweeping(sweep(name), {.folder = folder_.path()});
    const double after_s = std::uniform_real_distribution<double>(0, took_s_)(random_);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(after_s);
    while (std::chrono::steady_clock::now() < end && sweeping.is_running()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    switch (std::uniform_int_distribution(0, 2)(random_)) {
      case 0:
        sweeping.signal(SIGKILL);
        break;
      case 1:
        sweeping.signal(SIGTERM);  // its cases write checkpoints
        break;
      default:
        kill_a_case(sweeping);
    }
    return sweeping.wait().exit_code == 0;
  }

  static void kill_a_case(Process& sweeping) {
    std::ifstream children("/proc/" + std::to_string(sweeping.id()) + "/task/" +
                           std::to_string(sweeping.id()) + "/children");
    pid_t child = 0;
    if (children >> child) ::kill(child, SIGKILL);
  }

  TempFolder folder_;
  nlohmann::json whole_;
  double took_s_ = 0;
  std::mt19937 random_{1};
};

}  // namespace lsos::test
