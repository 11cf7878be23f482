// The same plan gives the same log, value for value, however it is run.

#include <gtest/gtest.h>

#include <algorithm>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

class EqualRuns : public ::testing::Test {
 protected:
  std::string digest(const Words& options = {}) const {
    return digest_of(TempFolder(), plan_, options);
  }

  std::vector<Mark> plan_ = two_rovers();
  std::string first_ = digest({"--threads", "1"});
};

TEST_F(EqualRuns, follow_from_the_same_plan_again) {
  EXPECT_EQ(first_.size(), 64u);
  EXPECT_EQ(digest({"--threads", "1"}), first_);
}

TEST_F(EqualRuns, follow_with_any_number_of_threads) {
  EXPECT_EQ(digest({"--threads", "2"}), first_);
  EXPECT_EQ(digest({"--threads", "7"}), first_);
  EXPECT_EQ(digest(), first_);
}

TEST_F(EqualRuns, follow_from_any_order_of_placemarks) {
  std::ranges::reverse(plan_);
  EXPECT_EQ(digest(), first_);
  std::ranges::rotate(plan_, plan_.begin() + 3);
  EXPECT_EQ(digest(), first_);
}

TEST_F(EqualRuns, follow_when_all_state_is_saved_and_read_back_at_each_exchange) {
  EXPECT_EQ(digest({"--save-every-exchange"}), first_);
}

TEST_F(EqualRuns, do_not_follow_from_another_plan) {
  plan_.back().geometry = point("0.0005,-0.00070001");  // shifted by 0.3 mm
  EXPECT_NE(digest(), first_);
}

}  // namespace
}  // namespace lsos::test
