// When a study knows enough, against published intervals and fresh samples.
#include "study/stop_rule.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/random.h"

namespace lsos {
namespace {

std::vector<double> first(int count) {
  std::vector<double> values;
  for (int i = 1; i <= count; ++i) values.push_back(i);
  return values;
}

// The published table of ranks of a median's 95 % interval: 6 is the least count that has one.
TEST(QuantileInterval, has_the_ranks_of_the_table) {
  EXPECT_FALSE(quantile_interval(first(5), 0.5));
  const std::tuple<int, double, double> table[] = {{6, 1, 6},   {9, 2, 8},    {10, 2, 9},
                                                   {20, 6, 15}, {50, 18, 33}, {100, 40, 61}};
  for (const auto& [count, low, high] : table) {
    const auto found = quantile_interval(first(count), 0.5);
    ASSERT_TRUE(found) << count;
    EXPECT_EQ(found->low, low) << count;
    EXPECT_EQ(found->high, high) << count;
  }
}

// 0.95^n <= 0.025 from 72 cases on: fewer say nothing of P5's lower side.
TEST(QuantileInterval, of_a_rare_value_needs_many_cases) {
  EXPECT_FALSE(quantile_interval(first(71), 0.05));
  EXPECT_FALSE(quantile_interval(first(71), 0.95));
  EXPECT_EQ(quantile_interval(first(72), 0.05)->low, 1);
  EXPECT_EQ(quantile_interval(first(72), 0.95)->high, 72);
}

TEST(QuantileInterval, holds_the_quantile_of_fresh_samples) {
  RandomStream random(9);
  constexpr int trials = 2000;
  for (const double quantile : {0.05, 0.5, 0.9}) {
    int holds = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> values;
      for (int i = 0; i < 120; ++i) values.push_back(random.uniform());
      std::ranges::sort(values);
      const auto found = quantile_interval(values, quantile);
      holds += found->low <= quantile && quantile <= found->high ? 1 : 0;
    }
    EXPECT_GE(holds, 0.94 * trials) << quantile;
    EXPECT_LE(holds, 0.985 * trials) << quantile;
  }
}

TEST(HalfWidth, is_of_what_the_rule_asks) {
  StopRule rule;
  rule.of = share_completed;
  std::vector<double> values(100, 1.0);
  std::fill_n(values.begin(), 10, 0.0);
  // Wilson's interval of 90 of 100: 0.8256 to 0.9448.
  EXPECT_NEAR(*half_width(rule, values), 0.0596, 1e-4);
  rule.of = "least charge";
  rule.quantile = 0.5;
  EXPECT_EQ(*half_width(rule, first(100)), 10.5);
  EXPECT_FALSE(half_width(rule, {}));
}

}  // namespace
}  // namespace lsos
