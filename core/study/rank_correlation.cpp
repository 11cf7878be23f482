#include "study/rank_correlation.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace lsos {

namespace {

// Indices of the values, the least first.
std::vector<std::size_t> ascending(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  return order;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Pearson's correlation; absent where one of the two does not vary.
std::optional<double> correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const double mean_x = mean(x), mean_y = mean(y);
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(xx > 0 && yy > 0)) return {};
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

// t = rho sqrt((n - 2) / (1 - rho^2)) has n - 2 degrees of freedom where nothing correlates.
std::optional<double> significance(double rho, std::size_t cases) {
  if (cases < significance_cases_min) return {};
  const double rest = 1 - rho * rho, freedom = static_cast<double>(cases - 2);
  if (!(rest > 0)) return 0.0;
  const double t = std::abs(rho) * std::sqrt(freedom / rest);
  return 2 * cdf(complement(boost::math::students_t_distribution<double>(freedom), t));
}

}  // namespace

std::vector<double> average_ranks(const std::vector<double>& values) {
  const std::vector<std::size_t> order = ascending(values);
  std::vector<double> ranks(values.size());
  for (std::size_t from = 0, to = 0; from < order.size(); from = to) {
    while (to < order.size() && values[order[to]] == values[order[from]]) ++to;
    const double shared = (static_cast<double>(from + 1) + static_cast<double>(to)) / 2;
    for (std::size_t i = from; i < to; ++i) ranks[order[i]] = shared;
  }
  return ranks;
}

std::optional<RankCorrelation> rank_correlation(const std::vector<double>& x,
                                                const std::vector<double>& y) {
  constexpr std::size_t cases_min = 3;
  std::vector<double> both_x, both_y;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    both_x.push_back(x[i]);
    both_y.push_back(y[i]);
  }
  if (both_x.size() < cases_min) return {};
  const std::optional<double> rho = correlation(average_ranks(both_x), average_ranks(both_y));
  if (!rho) return {};
  return RankCorrelation{*rho, significance(*rho, both_x.size()), both_x.size()};
}

std::vector<bool> discoveries(const std::vector<double>& p, double rate) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<bool> found(p.size(), false);
  for (std::size_t k = order.size(); k-- > 0;) {
    const double limit = rate * static_cast<double>(k + 1) / static_cast<double>(p.size());
    if (p[order[k]] > limit) continue;
    for (std::size_t i = 0; i <= k; ++i) found[order[i]] = true;
    break;
  }
  return found;
}

}  // namespace lsos
