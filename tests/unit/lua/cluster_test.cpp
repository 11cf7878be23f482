// What `sweep` takes for clusters.
#include <gtest/gtest.h>

#include "lua/study/cluster_options.h"
#include "lua/study/slurm.h"

namespace lsos {
namespace {

// The forms that `man sbatch` lists for --time.
TEST(TimeLimit, is_written_as_for_slurm) {
  EXPECT_EQ(time_limit_s("90"), 90 * 60);
  EXPECT_EQ(time_limit_s("90:30"), 90 * 60 + 30);
  EXPECT_EQ(time_limit_s("1:30:05"), 5405);
  EXPECT_EQ(time_limit_s("2-12"), 60 * 3600);
  EXPECT_EQ(time_limit_s("2-12:30"), 60 * 3600 + 1800);
  EXPECT_EQ(time_limit_s("2-12:30:01"), 60 * 3600 + 1801);
}

TEST(TimeLimit, is_five_minutes_or_more) {
  EXPECT_EQ(time_limit_s("5"), 300);
  for (const char* text :
       {"", "0", "4:59", "-5", "1h", "1:2:3:4", "1-", "90 ", "1.5", "99999999"}) {
    EXPECT_FALSE(time_limit_s(text)) << text;
  }
}

TEST(TaskArrays, have_no_more_tasks_than_slurm_takes) {
  const auto arrays = task_arrays(25, 10);
  ASSERT_EQ(arrays.size(), 3u);
  EXPECT_EQ(arrays[2].before, 20);
  EXPECT_EQ(arrays[2].count, 5);
  EXPECT_EQ(task_arrays(10, 10).size(), 1u);
}

TEST(TaskArrays, wait_for_each_other_only_with_a_limit) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(array_words({10, 5}, 0, {"12"}), (Words{"--array=1-5"}));
  EXPECT_EQ(array_words({0, 5}, 2, {}), (Words{"--array=1-5%2"}));
  EXPECT_EQ(array_words({10, 5}, 2, {"11", "12"}),
            (Words{"--array=1-5%2", "--dependency=afterany:12"}));
  EXPECT_EQ(gather_words({"11", "12"}), (Words{"--dependency=afterany:11:12"}));
}

}  // namespace
}  // namespace lsos
