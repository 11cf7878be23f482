// Rows of a picture's ground, shared among threads. Which thread does which row must not matter.
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace lsos {

// `start()` makes what one thread works with, `row(work, k)` does one row. What one throws is
// thrown here, after all have ended.
template <class Start, class Row>
void share_rows(int rows, const Start& start, const Row& row) {
  std::atomic<int> next = 0;
  const auto work = [&] {
    auto own = start();
    for (int k = next++; k < rows; k = next++) row(own, k);
  };
  std::vector<std::future<void>> others;
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
  for (unsigned k = 1; k < threads; ++k) {
    others.push_back(std::async(std::launch::async, work));
  }
  work();
  for (auto& other : others) other.get();
}

}  // namespace lsos
