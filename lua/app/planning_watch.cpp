#include "lua/app/planning_watch.h"

#include <fmt/format.h>

#include <chrono>

#include "base/console.h"

namespace lsos {

namespace {

constexpr std::chrono::seconds first_after{2}, then_every{10};

}  // namespace

PlanningWatch::PlanningWatch(bool is_quiet) {
  if (!is_quiet) thread_ = std::thread([this] { watch(); });
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
  std::unique_lock lock(mutex_);
  while (!is_ending_) {
    const long long now = number_;
    const auto is_other = [&] { return is_ending_ || number_ != now; };
    if (what_.empty()) {
      changed_.wait(lock, is_other);
      continue;
    }
    const auto begin = std::chrono::steady_clock::now();
    for (auto wait = first_after; !changed_.wait_for(lock, wait, is_other); wait = then_every) {
      const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begin;
      print_message("planning {}: {:.0f} s so far\n", what_, so_far.count());
    }
  }
}

}  // namespace lsos
