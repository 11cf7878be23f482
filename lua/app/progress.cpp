#include "lua/app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "base/console.h"

namespace lsos {

namespace {

constexpr int bar_width = 30;
constexpr auto redraw = std::chrono::milliseconds(100);
constexpr auto line_every = std::chrono::seconds(10);

}  // namespace

Progress::Progress(bool is_quiet, double from_s)
    : is_quiet_(is_quiet), is_terminal_(isatty(STDERR_FILENO) != 0), from_s_(from_s) {}

void Progress::show(double share, std::optional<double> sim_s) {
  const Clock::time_point now = Clock::now();
  if (is_quiet_ || now - drawn_ < (is_terminal_ ? redraw : Clock::duration(line_every))) return;
  drawn_ = now;
  const double wall_s = std::chrono::duration<double>(now - begin_).count();
  const int full = static_cast<int>(share * bar_width);
  std::string state;
  if (sim_s) {
    state = fmt::format("{} simulated, {:.0f} x real time", clock_text(*sim_s),
                        (*sim_s - from_s_) / wall_s);
  } else if (share > 0) {
    state = fmt::format("{} left", clock_text(wall_s * (1 - share) / share));
  }
  print_message("{}[{:=<{}}{: <{}}] {:3.0f} %  {}{}", is_terminal_ ? "\r" : "", "", full, "",
                bar_width - full, share * 100, state, is_terminal_ ? "\x1b[K" : "\n");
}

void Progress::finish() {
  if (!is_quiet_ && is_terminal_) print_message("\r\x1b[K");
}

std::string clock_text(double time_s) {
  const auto whole = static_cast<std::int64_t>(time_s);
  const std::int64_t days = whole / 86400, rest = whole % 86400;
  const std::string clock =
      fmt::format("{:02}:{:02}:{:02}", rest / 3600, rest / 60 % 60, rest % 60);
  return days > 0 ? fmt::format("{} d {}", days, clock) : clock;
}

}  // namespace lsos
