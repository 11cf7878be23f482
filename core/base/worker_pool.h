// Threads that do parts of a task at the same time, such as stepping rovers between two exchanges.
#pragma once

#include <atomic>
#include <barrier>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace lsos {

class WorkerPool {
 public:
  // `threads` >= 1, the caller's own included.
  explicit WorkerPool(int threads);
  ~WorkerPool();

  // Calls work(0) .. work(count - 1), each once, from any thread; returns when all are done. The
  // first exception by index is thrown again here.
  void for_each(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void serve();
  void run_pending();

  std::size_t count_ = 0;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::atomic<std::size_t> next_{0};
  bool is_ending_ = false;
  std::vector<std::exception_ptr> errors_;
  std::barrier<> begin_, end_;
  std::vector<std::jthread> threads_;  // last, so that they are joined before members they use
};

}  // namespace lsos
