// Progress of a command on standard error: a bar on a terminal, a line a minute elsewhere.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace lsos {

class Progress {
 public:
  // `from_s`: where a mission's time stands now.
  explicit Progress(bool is_quiet, double from_s = 0);

  // `share`: completed part, 0..1. Draws when is_due(), with the time that is left.
  void show(double share);
  // Shows a mission at its time `sim_s`. `left_s`: wall time that is left, where it is known.
  // `what`: what is being done.
  void show_mission(double share, double sim_s, std::optional<double> left_s,
                    const std::string& what);
  // Shows what else is said of how far it is. `left_s`: as above.
  void show_state(double share, const std::string& state, std::optional<double> left_s);
  // Ten times a second on a terminal, else once a minute: what is to be shown need not be found out
  // more often.
  bool is_due() const;
  // Removes the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void draw(double share, const std::string& state);

  bool is_quiet_;
  bool is_terminal_;
  double from_s_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point drawn_ = begin_;
};

// Time as a clock shows it: "2 d 03:04:05", "00:12:30".
std::string clock_text(double time_s);

}  // namespace lsos
