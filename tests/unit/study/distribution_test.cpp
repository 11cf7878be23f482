// Distributions against their closed forms.
#include "study/distribution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lsos::test {
namespace {

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2)); }

TEST(Distribution, of_equal_chances_is_a_line) {
  EXPECT_DOUBLE_EQ(quantile(Uniform{2, 6}, 0), 2);
  EXPECT_DOUBLE_EQ(quantile(Uniform{2, 6}, 0.25), 3);
}

TEST(Distribution, that_is_normal_is_cut_off) {
  const Normal normal{10, 2, 7, 12};
  const double low = normal_cdf(-1.5), high = normal_cdf(1);
  for (const double share : {0.01, 0.3, 0.5, 0.9, 0.999}) {
    const double value = quantile(normal, share);
    EXPECT_NEAR((normal_cdf((value - 10) / 2) - low) / (high - low), share, 1e-12);
  }
  EXPECT_DOUBLE_EQ(quantile(normal, 0), 7);
  EXPECT_LE(quantile(normal, 1 - 0x1.0p-53), 12);
}

// Six deviations above the mean nothing is left of P(x) in double precision, but of its complement.
TEST(Distribution, that_is_normal_keeps_its_tails) {
  const Normal tail{0, 1, 6, 8};
  EXPECT_NEAR(quantile(tail, 0), 6, 1e-9);
  const double half = quantile(tail, 0.5);
  const double above = 0.5 * std::erfc(half / std::sqrt(2)),
               all = 0.5 * std::erfc(6 / std::sqrt(2)) - 0.5 * std::erfc(8 / std::sqrt(2));
  EXPECT_NEAR((0.5 * std::erfc(6 / std::sqrt(2)) - above) / all, 0.5, 1e-9);
  EXPECT_NEAR(quantile(Normal{0, 1, -8, -6}, 0.5), -half, 1e-9) << "both tails are alike";
}

TEST(Distribution, that_is_triangular_has_its_mode) {
  const Triangular triangular{0, 1, 4};
  EXPECT_DOUBLE_EQ(quantile(triangular, 0.25), 1) << "a quarter of the area lies below the mode";
  const double upper = quantile(triangular, 0.9);
  EXPECT_NEAR(1 - (4 - upper) * (4 - upper) / 12, 0.9, 1e-12);
  EXPECT_DOUBLE_EQ(quantile(Triangular{0, 0, 1}, 0.75), 0.5) << "the mode may be an end";
}

}  // namespace
}  // namespace lsos::test
