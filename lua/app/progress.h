// Progress of a command on standard error: a bar on a terminal, an occasional line elsewhere.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace lsos {

class Progress {
 public:
  // `from_s`: where a mission's time stands now.
  explicit Progress(bool is_quiet, double from_s = 0);

  // `share`: completed part, 0..1. Draws at most ten times a second. With `sim_s`: of a mission,
  // with the time simulated; without: with the time that is left.
  void show(double share, std::optional<double> sim_s = {});
  // Removes the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_quiet_;
  bool is_terminal_;
  double from_s_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point drawn_ = begin_;
};

// Time as a clock shows it: "2 d 03:04:05", "00:12:30".
std::string clock_text(double time_s);

}  // namespace lsos
