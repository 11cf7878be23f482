#include "system/killed_runs.h"

#include <csignal>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/error.h"
#include "record/log.h"

namespace lsos::test {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A log whose last commit was cut off is read as it was before.
bool has_checkpoint(const fs::path& log) {
  try {
    return !LogReader(log.string()).checkpoints().empty();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void KilledRuns::whole_run(const std::vector<Mark>& marks) {
  whole_run(folder_.write("plan.kml", kml(marks)));
}

void KilledRuns::whole_run(const std::string& plan, const Words& options) {
  plan_ = plan;
  options_ = options;
  const auto begin = Clock::now();
  const Outcome outcome = run(with({plan_, "-o", folder_ / "whole"}, options));
  ASSERT_LE(outcome.exit_code, 1) << outcome.err;
  took_s_ = seconds_since(begin);
  digest_ = summary(folder_ / "whole")["log_sha256"];
}

// Starts a run and kills it after this time. False when it had ended by itself.
bool KilledRuns::kill_after(const Words& words, double after_s) {
  Process process(program(words));
  const auto begin = Clock::now();
  while (seconds_since(begin) < after_s) {
    if (!process.is_running()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  process.signal(SIGKILL);
  return process.wait().was_killed;
}

void KilledRuns::kill_and_resume(int count, bool counts_early_ones) {
  int done = 0;
  for (int k = 0; k < 10 * count && done < count && !HasFailure(); ++k) {
    done += kill_and_resume_once(counts_early_ones);
  }
  EXPECT_EQ(done, count);
}

// Kills a run, resumes it, kills that too, and resumes it to its end. The time that a run takes is
// learnt on the way, as the machine may be busier than it was during the whole run. Returns whether
// the first kill was at a moment that counts.
bool KilledRuns::kill_and_resume_once(bool counts_early_ones) {
  const fs::path run_folder = folder_ / "run";
  fs::remove_all(run_folder);
  fs::remove(plan_ + ".routes");  // so that routes are planned again
  std::uniform_real_distribution<double> share(counts_early_ones ? 0.0 : 0.15, 0.95);
  const Words first = with({plan_, "-o", run_folder}, options_);
  if (!kill_after(first, share(random_) * took_s_)) {
    took_s_ *= 0.7;
    return false;
  }
  if (!has_checkpoint(run_folder / "log.gpkg")) {
    EXPECT_EQ(run({"resume", run_folder}).exit_code, 2) << "before its first checkpoint";
    if (!counts_early_ones) took_s_ *= 1.3;
    return counts_early_ones;
  }
  const std::string threads = std::to_string(1 + random_() % 3);
  const Words resume = {"resume", run_folder, "--no-report", "--quiet", "--threads", threads};
  kill_after(resume, share(random_) * took_s_);
  if (!fs::exists(run_folder / "summary.json")) {  // else it had ended
    const Outcome outcome = run(resume);
    EXPECT_LE(outcome.exit_code, 1) << outcome.err;
  }
  EXPECT_EQ(summary(run_folder)["log_sha256"], digest_);
  EXPECT_EQ(summary(run_folder)["events"], summary(folder_ / "whole")["events"]);
  EXPECT_EQ(summary(run_folder)["warnings"], summary(folder_ / "whole")["warnings"]);
  return true;
}

}  // namespace lsos::test
