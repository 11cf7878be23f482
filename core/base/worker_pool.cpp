#include "base/worker_pool.h"

namespace lsos {

// Where the machine makes no more threads, those that began share the work: what is computed does
// not depend on their number.
WorkerPool::WorkerPool(int threads) : begin_(threads), end_(threads) {
  threads_.reserve(static_cast<std::size_t>(threads));
  try {
    for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { serve(); });
  } catch (const std::exception&) {
    for (auto i = static_cast<int>(threads_.size()) + 1; i < threads; ++i) {
      begin_.arrive_and_drop();
      end_.arrive_and_drop();
    }
  }
}

WorkerPool::~WorkerPool() {
  is_ending_ = true;
  begin_.arrive_and_wait();
}

void WorkerPool::serve() {
  while (true) {
    begin_.arrive_and_wait();
    if (is_ending_) return;
    run_pending();
    end_.arrive_and_wait();
  }
}

void WorkerPool::run_pending() {
  for (std::size_t i = next_++; i < count_; i = next_++) {
    try {
      (*work_)(i);
    } catch (const std::exception&) {
      errors_[i] = std::current_exception();
    }
  }
}

void WorkerPool::for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
  // A single piece of work runs on the calling thread: waking others does not pay.
  if (threads_.empty() || count < 2) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  count_ = count;
  work_ = &work;
  next_ = 0;
  errors_.assign(count, nullptr);
  begin_.arrive_and_wait();
  run_pending();
  end_.arrive_and_wait();
  for (const std::exception_ptr& error : errors_) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace lsos
