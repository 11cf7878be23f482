#include "base/worker_pool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

// In a process that may make no thread: 0 when fewer threads do all of the work.
int work_without_threads() {
  constexpr uid_t nobody = 65534;
  constexpr unsigned seconds_max = 20;
  alarm(seconds_max);  // ends a pool that waits for threads which do not come
  if (geteuid() == 0 && setuid(nobody) != 0) return 2;  // the limit does not hold root
  const rlimit none{1, 1};
  if (setrlimit(RLIMIT_NPROC, &none) != 0) return 3;
  WorkerPool pool(4);
  std::vector<int> done(17, 0);
  for (int round = 0; round < 3; ++round) {
    pool.for_each(done.size(), [&](std::size_t i) { ++done[i]; });
  }
  return std::ranges::count(done, 3) == 17 ? 0 : 4;
}

TEST(WorkerPool, does_its_work_where_no_thread_can_be_made) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(work_without_threads());
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace lsos
