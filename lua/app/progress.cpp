#include "lua/app/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/console.h"
#include "base/visible_text.h"

namespace lsos {

namespace {

constexpr int bar_width = 30;
constexpr auto redraw = std::chrono::milliseconds(100);
constexpr auto progress_line_every = std::chrono::seconds(60);

// "40 s", "12 min", "3 h 20 min": an estimate has no more digits.
std::string rough_time(double time_s) {
  if (time_s < 90) return fmt::format("{:.0f} s", std::ceil(time_s / 10) * 10);
  const auto minutes = static_cast<int>(std::lround(time_s / 60));
  if (minutes < 90) return fmt::format("{} min", minutes);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace

Progress::Progress(bool is_quiet, double from_s)
    : is_quiet_(is_quiet), is_terminal_(isatty(STDERR_FILENO) != 0), from_s_(from_s) {}

bool Progress::is_due() const {
  return !is_quiet_ &&
         Clock::now() - drawn_ >= (is_terminal_ ? redraw : Clock::duration(progress_line_every));
}

void Progress::show(double share) {
  if (!is_due()) return;
  const double wall_s = std::chrono::duration<double>(Clock::now() - begin_).count();
  draw(share, share > 0 ? fmt::format("{} left", clock_text(wall_s * (1 - share) / share))
                        : std::string());
}

void Progress::show_mission(double share, double sim_s, std::optional<double> left_s,
                            const std::string& what) {
  if (!is_due()) return;
  const double wall_s = std::chrono::duration<double>(Clock::now() - begin_).count();
  draw(share, fmt::format("{} simulated, {:.0f} x real time{}{}", clock_text(sim_s),
                          (sim_s - from_s_) / wall_s,
                          left_s ? fmt::format(", {} left", rough_time(*left_s)) : "",
                          what.empty() ? "" : ", " + what));
}

void Progress::show_state(double share, const std::string& state, std::optional<double> left_s) {
  if (!is_due()) return;
  draw(share, left_s ? fmt::format("{}, {} left", state, rough_time(*left_s)) : state);
}

void Progress::draw(double share, const std::string& state) {
  drawn_ = Clock::now();
  const int full = static_cast<int>(share * bar_width);
  const std::string line = fmt::format("[{:=<{}}{: <{}}] {:3.0f} %  {}", "", full, "",
                                       bar_width - full, share * 100, visible_text(state));
  if (!is_terminal_) return print_message("{}\n", line);
  // A line that wraps cannot be drawn over. It is cut before a character, not within one of UTF-8.
  winsize size{};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  std::size_t end = std::min(line.size(), is_known ? size.ws_col - 1U : line.size());
  while (end > 0 && end < line.size() && (line[end] & 0xc0) == 0x80) --end;
  redraw_message(line.substr(0, end));
}

void Progress::finish() {
  if (!is_quiet_ && is_terminal_) redraw_message("");
}

std::string clock_text(double time_s) {
  const auto whole = static_cast<std::int64_t>(time_s);
  const std::int64_t days = whole / 86400, rest = whole % 86400;
  const std::string clock =
      fmt::format("{:02}:{:02}:{:02}", rest / 3600, rest / 60 % 60, rest % 60);
  return days > 0 ? fmt::format("{} d {}", days, clock) : clock;
}

}  // namespace lsos
