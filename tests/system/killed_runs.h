// Runs that are killed at random moments and resumed, against one that was not.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "system/run_folder.h"

namespace lsos::test {

// Many checkpoints, and so many commits, that a kill often falls into one.
inline const Words dense = {"--checkpoint-every", "2 s", "--no-report", "--quiet"};

Words with(Words words, const Words& more);

// A plan, and the digest of its run in one piece.
class KilledRuns : public ::testing::Test {
 protected:
  void whole_run(const std::vector<Mark>& marks);
  // The same of a plan's file. `options`: besides those that name the plan and the folder.
  void whole_run(const std::string& plan, const Words& options = dense);

  // Kills runs at `count` random moments and resumes them, each killed a second time on its way,
  // with one to three threads. Runs that are killed before there is anything to resume count too
  // when `counts_early_ones`.
  void kill_and_resume(int count, bool counts_early_ones = false);

  TempFolder folder_;
  std::string plan_, digest_;
  double took_s_ = 0;

 private:
  bool kill_after(const Words& words, double after_s);
  bool kill_and_resume_once(bool counts_early_ones);

  Words options_ = dense;
  std::mt19937 random_{1};
};

}  // namespace lsos::test
