// Which way a result moves with a parameter: Spearman's rank correlation.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace lsos {

struct RankCorrelation {
  double rho = 0;  // -1..1
  // Probability that chance alone gives one as strong in either direction, by Student's
  // distribution; absent where there are fewer than significance_cases_min cases.
  std::optional<double> p;
  std::size_t cases = 0;  // that have both values
};

// Student's distribution describes rho of fewer cases badly.
inline constexpr std::size_t significance_cases_min = 10;

// Ranks from 1; equal values share the mean of their ranks. Values must be finite.
std::vector<double> average_ranks(const std::vector<double>& values);

// `x`, `y`: of the same cases. Cases in which one of them is not finite are left out. Absent where
// fewer than three are left, or one of the two does not vary.
std::optional<RankCorrelation> rank_correlation(const std::vector<double>& x,
                                                const std::vector<double>& y);

// Which of many tests, each with its `p`, have found something, so that at most the share `rate` of
// those found is expected to be chance (Benjamini and Hochberg 1995).
std::vector<bool> discoveries(const std::vector<double>& p, double rate);

}  // namespace lsos
