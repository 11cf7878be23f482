#include "lua/app/planning_watch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <system_error>

#include "base/console.h"

namespace lsos {

namespace {

// On a terminal one line is drawn over; elsewhere a long search has a line a minute.
constexpr std::chrono::seconds first_after{2}, redraw_every{1}, planning_line_every{60};

}  // namespace

PlanningWatch::PlanningWatch(bool is_quiet) {
  if (is_quiet) return;
  try {
    thread_ = std::thread([this] { watch(); });
  } catch (const std::system_error&) {
    // Where the machine makes no more threads, the plan is made without these lines.
  }
}

PlanningWatch::~PlanningWatch() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void PlanningWatch::plan(const std::string& what) {
  {
    const std::lock_guard lock(mutex_);
    what_ = what;
    ++number_;
  }
  changed_.notify_all();
}

void PlanningWatch::watch() {
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  std::unique_lock lock(mutex_);
  while (!is_ending_) {
    const long long now = number_;
    const auto is_other = [&] { return is_ending_ || number_ != now; };
    if (what_.empty()) {
      changed_.wait(lock, is_other);
      continue;
    }
    const auto begin = std::chrono::steady_clock::now();
    bool is_drawn = false;
    for (auto wait = first_after; !changed_.wait_for(lock, wait, is_other);
         wait = is_terminal ? redraw_every : planning_line_every) {
      const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begin;
      const std::string line = fmt::format("planning {}: {:.0f} s so far", what_, so_far.count());
      is_terminal ? redraw_message(line) : print_message("{}\n", line);
      is_drawn = true;
    }
    if (is_drawn && is_terminal) redraw_message("");
  }
}

}  // namespace lsos
