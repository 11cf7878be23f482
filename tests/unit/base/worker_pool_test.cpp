#include "base/worker_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace lsos {
namespace {

TEST(WorkerPool, does_each_piece_once_on_any_number_of_threads) {
  for (const int threads : {1, 2, 5}) {
    WorkerPool pool(threads);
    for (int round = 0; round < 200; ++round) {
      std::vector<int> done(17, 0);
      pool.for_each(done.size(), [&](std::size_t i) { ++done[i]; });
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 17);
      EXPECT_EQ(*std::ranges::max_element(done), 1);
    }
  }
}

TEST(WorkerPool, throws_the_first_error_by_index) {
  WorkerPool pool(3);
  for (int round = 0; round < 50; ++round) {
    try {
      pool.for_each(8, [](std::size_t i) {
        if (i % 3 == 1) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "1");
    }
  }
}

}  // namespace
}  // namespace lsos
