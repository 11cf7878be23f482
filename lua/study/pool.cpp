#include "lua/study/pool.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <exception>

namespace lsos {

namespace {

std::atomic<int> noted_signal{0};

// A second Ctrl-C ends the program at once. A second SIGTERM does not: a batch system sends one to
// all processes of a job, and the job's shell may pass on its own.
void note_stop(int signal) {
  noted_signal = signal;
  if (signal == SIGINT) std::signal(signal, SIG_DFL);
}

// What asks a case to stop. A SIGTERM that the case was sent by others is no second one of these.
constexpr int stop_of_case = SIGHUP;

// Its arrival ends the sleep of the loop.
void note_child(int) {}

// What a case prints is in its summary.
void silence() {
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing < 0) return;
  dup2(nothing, STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
}

}  // namespace

void note_signals_for_pool() {
  std::signal(SIGINT, note_stop);
  std::signal(SIGTERM, note_stop);
}

void Pool::start(std::int64_t number) {
  const pid_t self = getpid();
  std::optional<ChildProcess> child = ChildProcess::fork();
  if (child) {
    children_.emplace(number, std::move(*child));
    return;
  }
  // A case whose pool was killed stops as if it had been told to.
  prctl(PR_SET_PDEATHSIG, stop_of_case);
  if (getppid() != self) _exit(1);
  std::signal(stop_of_case, SIG_DFL);  // which nohup has let this process ignore
  std::signal(SIGCHLD, SIG_DFL);
  setpgid(0, 0);  // a terminal's Ctrl-C comes through the pool
  silence();
  // The parent's buffers and objects are not this process's: nothing of them is destroyed.
  try {
    _exit(work_(number));
  } catch (const std::exception&) {
    constexpr int internal_fault = 70;  // none of what the work returns
    _exit(internal_fault);
  }
}

int Pool::run(const std::vector<std::int64_t>& numbers, const Ended& on_end,
              const std::function<void()>& on_turn) {
  note_signals_for_pool();
  std::signal(SIGCHLD, note_child);
  std::size_t next = 0;
  bool is_stopping = false;
  const auto has_next = [&] { return next < numbers.size() && numbers[next] <= last_; };
  while (!children_.empty() || (has_next() && !is_stopping)) {
    if (noted_signal != 0 && !is_stopping) {
      is_stopping = true;
      for (const auto& [number, child] : children_) child.send(stop_of_case);
    }
    while (!is_stopping && children_.size() < processes_ && has_next()) {
      start(numbers[next++]);
    }
    for (auto child = children_.begin(); child != children_.end();) {
      const std::optional<ChildProcess::Ending> ending = child->second.poll();
      if (ending) on_end(child->first, *ending);
      child = ending ? children_.erase(child) : std::next(child);
    }
    on_turn();
    const bool may_start = !is_stopping && has_next() && children_.size() < processes_;
    if (may_start || children_.empty()) continue;
    const timespec turn{0, 50'000'000};
    nanosleep(&turn, nullptr);
  }
  return noted_signal;
}

}  // namespace lsos
