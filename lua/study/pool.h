// Processes that run the cases of a study, some at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "base/child_process.h"

namespace lsos {

// From now on a first SIGINT or SIGTERM is noted for the pool, which then begins nothing. For a
// program that a batch system may stop while it still reads.
void note_signals_for_pool();

class Pool {
 public:
  // What a process does with a case; what it returns is its exit code.
  using Work = std::function<int(std::int64_t number)>;
  // Told of each case that has ended, with how its process ended.
  using Ended = std::function<void(std::int64_t number, const ChildProcess::Ending& ending)>;

  Pool(std::size_t processes, Work work) : processes_(processes), work_(std::move(work)) {}

  // Runs the cases in their order, which is that of their numbers. Each process is forked from this
  // one, which must have no threads. `on_turn` is called some ten times a second. At a first SIGINT
  // or SIGTERM the processes are asked to stop with a checkpoint. Returns the signal, or 0 when all
  // have ended.
  int run(const std::vector<std::int64_t>& numbers, const Ended& on_end,
          const std::function<void()>& on_turn);

  std::size_t running() const { return children_.size(); }
  // No case with a greater number is begun any more; those that run go on.
  void begin_none_after(std::int64_t number) { last_ = number; }

 private:
  void start(std::int64_t number);

  std::size_t processes_;
  Work work_;
  std::int64_t last_ = std::numeric_limits<std::int64_t>::max();
  std::map<std::int64_t, ChildProcess> children_;
};

}  // namespace lsos
