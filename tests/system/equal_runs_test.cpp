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

// Beside the plan lie the routes that its first run planned.
TEST_F(EqualRuns, follow_with_planned_routes_that_are_known) {
  const TempFolder folder;
  plan_ = {mission(), sev("SEV1", "0,0"),
           event("PathPlanRoute", "SEV1", 1, {}, point("0.003,0.001"))};
  plan_.front().fields = {{"Planet", "Moon"},
                          {"StartTime", "2026-01-01T00:00:00Z"},
                          {"Terrain", "Craters"},
                          {"LogInterval", "2"}};
  const std::string cold = digest_of(folder, plan_, {});
  EXPECT_GT(std::filesystem::file_size(folder / "plan.kml.routes"), 100u);
  EXPECT_EQ(digest_of(folder, plan_, {}), cold);
  EXPECT_EQ(digest(), cold);
}

TEST_F(EqualRuns, do_not_follow_from_another_plan) {
  plan_.back().geometry = point("0.0005,-0.00070001");  // shifted by 0.3 mm
  EXPECT_NE(digest(), first_);
}

}  // namespace
}  // namespace lsos::test
