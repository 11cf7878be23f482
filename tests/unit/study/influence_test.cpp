// Which parameter moves which result, against published and closed forms.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "study/first_order.h"
#include "study/proportion.h"
#include "study/rank_correlation.h"
#include "study/sampling.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;

const double nan = std::numeric_limits<double>::quiet_NaN();

// Hours of television and IQ of ten people, the worked example of Wikipedia's article on Spearman's
// coefficient: rho = -29/165, p = 0.627188.
TEST(RankCorrelation, is_that_of_a_published_example) {
  const auto found = rank_correlation({106, 100, 86, 101, 99, 103, 97, 113, 112, 110},
                                      {7, 27, 2, 50, 28, 29, 20, 12, 6, 17});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rho, -29.0 / 165, 1e-12);
  ASSERT_TRUE(found->p);
  EXPECT_NEAR(*found->p, 0.627188, 1e-6);
  EXPECT_EQ(found->cases, 10u);
}

// Ties share the mean of their ranks: Pearson's correlation of 1, 2.5, 2.5, 4 and 1, 3, 2, 4.
TEST(RankCorrelation, gives_equal_values_equal_ranks) {
  EXPECT_THAT(average_ranks({10, 20, 20, 40, 5}), ElementsAre(2, 3.5, 3.5, 5, 1));
  const auto found = rank_correlation({10, 20, 20, 40}, {1, 3, 2, 9});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rho, 4.5 / std::sqrt(4.5 * 5), 1e-12);
  EXPECT_FALSE(found->p) << "four cases say nothing of chance";
}

TEST(RankCorrelation, sees_order_and_not_shape) {
  std::vector<double> x, y;
  for (int i = 0; i < 50; ++i) {
    x.push_back(i);
    y.push_back(-std::exp(0.3 * i));
  }
  EXPECT_EQ(rank_correlation(x, y)->rho, -1);
  EXPECT_EQ(*rank_correlation(x, y)->p, 0);
}

TEST(RankCorrelation, leaves_out_what_is_not_there) {
  const auto found = rank_correlation({1, nan, 2, 3, 4}, {1, 9, 2, nan, 3});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->cases, 3u);
  EXPECT_EQ(found->rho, 1);
  EXPECT_FALSE(rank_correlation({1, 2, 3}, {5, 5, 5}));
  EXPECT_FALSE(rank_correlation({1, 2}, {1, 2}));
}

// The example of Benjamini and Hochberg (1995): 15 tests at 0.05 reject the first four.
TEST(Discoveries, are_those_of_the_paper) {
  const std::vector<double> p{0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                              0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000};
  const std::vector<bool> found = discoveries(p, 0.05);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(found[i], i < 4) << i;
  EXPECT_TRUE(discoveries({}, 0.05).empty());
}

// A result of parameters that were drawn by a sampling, as a study draws them.
struct Drawn {
  std::vector<std::vector<double>> shares;  // by parameter
  std::vector<double> result;

  double share_of(std::size_t parameter) const {
    return first_order_share(classes_of(shares[parameter]), result)->share;
  }
};

template <class Function>
Drawn drawn(Sampling sampling, std::int64_t cases, std::size_t parameters, Function function) {
  std::vector<Dimension> dimensions;
  for (std::size_t k = 0; k < parameters; ++k) dimensions.push_back({"x" + std::to_string(k)});
  const Sampler sampler(sampling, 7, cases, dimensions);
  Drawn all{std::vector<std::vector<double>>(parameters), {}};
  for (std::int64_t number = 1; number <= cases; ++number) {
    std::vector<double> x;
    for (const auto& [name, share] : sampler.shares(number)) x.push_back(share);
    for (std::size_t k = 0; k < parameters; ++k) all.shares[k].push_back(x[k]);
    all.result.push_back(function(x));
  }
  return all;
}

constexpr Sampling samplings[] = {Sampling::random, Sampling::latin_hypercube, Sampling::sobol};

// y = 4 a + 2 b + c of uniform numbers: variances as 16 : 4 : 1.
TEST(FirstOrderShare, is_that_of_a_sum) {
  for (const Sampling sampling : samplings) {
    const Drawn all = drawn(
        sampling, 1000, 4, [](const std::vector<double>& x) { return 4 * x[0] + 2 * x[1] + x[2]; });
    EXPECT_NEAR(all.share_of(0), 16.0 / 21, 0.03) << to_string(sampling);
    EXPECT_NEAR(all.share_of(1), 4.0 / 21, 0.05) << to_string(sampling);
    EXPECT_NEAR(all.share_of(2), 1.0 / 21, 0.05) << to_string(sampling);
    EXPECT_NEAR(all.share_of(3), 0, 0.04) << to_string(sampling);
  }
}

// Ishigami and Homma (1990), a = 7, b = 0.1: first-order indices 0.3139, 0.4424 and 0. Ranks see
// nothing of the second parameter, whose effect is even.
TEST(FirstOrderShare, is_that_of_the_ishigami_function) {
  for (const Sampling sampling : samplings) {
    const Drawn all = drawn(sampling, 2000, 3, [](const std::vector<double>& share) {
      double x[3];
      for (int k = 0; k < 3; ++k)
        x[k] = std::numbers::pi * (2 * share[static_cast<std::size_t>(k)] - 1);
      return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) +
             0.1 * std::pow(x[2], 4) * std::sin(x[0]);
    });
    EXPECT_NEAR(all.share_of(0), 0.3139, 0.04) << to_string(sampling);
    EXPECT_NEAR(all.share_of(1), 0.4424, 0.04) << to_string(sampling);
    EXPECT_NEAR(all.share_of(2), 0, 0.03) << to_string(sampling);
    EXPECT_LT(std::abs(rank_correlation(all.shares[1], all.result)->rho), 0.06);
  }
}

// Without the correction of chance it would be (classes - 1)/(cases - 1) = 0.07 on average.
TEST(FirstOrderShare, of_a_parameter_without_effect_is_nought_on_average) {
  RandomStream random(3);
  double corrected = 0;
  int found = 0;
  constexpr int trials = 400, cases = 200;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> x, y;
    for (int i = 0; i < cases; ++i) {
      x.push_back(random.uniform());
      y.push_back(random.uniform());
    }
    const auto share = first_order_share(classes_of(x), y);
    corrected += share->share / trials;
    found += share->p < 0.05 ? 1 : 0;
  }
  EXPECT_LT(corrected, 0.025) << "negative ones count as 0";
  EXPECT_NEAR(found, 0.05 * trials, 3 * std::sqrt(0.05 * 0.95 * trials));
}

TEST(FirstOrderShare, takes_each_of_few_values_as_a_class) {
  std::vector<double> x, y;
  for (int i = 0; i < 90; ++i) {
    x.push_back(i % 3);
    y.push_back(i % 3 == 1 ? 10 : 2);
  }
  const auto found = first_order_share(classes_of(x), y);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->classes, 3u);
  EXPECT_EQ(found->share, 1);
  EXPECT_EQ(found->p, 0);
}

TEST(FirstOrderShare, is_absent_where_it_would_be_chance) {
  const std::vector<double> few{1, 2, 3, 4, 5, 6};
  EXPECT_FALSE(first_order_share(classes_of(few), few));
  const std::vector<double> same(100, 3.0);
  EXPECT_FALSE(first_order_share(classes_of(same), same));
}

// The interval that Wilson's formula gives for 8 of 10 (Brown, Cai and DasGupta 2001: 0.490,
// 0.943).
TEST(ShareInterval, is_wilsons) {
  EXPECT_NEAR(share_interval(8, 10).low, 0.4902, 1e-4);
  EXPECT_NEAR(share_interval(8, 10).high, 0.9433, 1e-4);
  EXPECT_EQ(share_interval(0, 20).low, 0);
  EXPECT_NEAR(share_interval(0, 20).high, 0.1611, 1e-4);
  EXPECT_NEAR(share_interval(20, 20).high, 1, 1e-12);
}

}  // namespace
}  // namespace lsos
