// Distributes rows of a picture's ground over threads. The result must not depend on which thread
// does which row.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

#include "base/worker_pool.h"

namespace lsos {

// `start()` creates the state of one thread, `row(state, k)` computes row k with it. An exception
// in a thread is rethrown here after all threads have ended.
template <class Start, class Row>
void parallel_for_rows(int rows, const Start& start, const Row& row) {
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
  std::atomic<int> next = 0;
  WorkerPool pool(static_cast<int>(threads));
  pool.for_each(threads, [&](std::size_t) {
    if (next >= rows) return;  // the others were faster
    auto own = start();
    for (int k = next++; k < rows; k = next++) row(own, k);
  });
}

}  // namespace lsos
