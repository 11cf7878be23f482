#include "study/stop_rule.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "base/error.h"
#include "study/proportion.h"

namespace lsos {

// How many of n values lie below the quantile is binomially distributed, B(n, quantile).
std::optional<QuantileInterval> quantile_interval(const std::vector<double>& sorted,
                                                  double quantile) {
  constexpr double beyond = 0.025;
  if (sorted.empty()) return {};
  const auto count = static_cast<double>(sorted.size());
  const boost::math::binomial_distribution<double> below(count, quantile);
  // The greatest rank that at most 2.5 % of samples have above the quantile, and the least that as
  // few have below it.
  double low = std::max(1.0, std::floor(count * quantile));
  while (low >= 1 && cdf(below, low - 1) > beyond) --low;
  double high = std::min(count, std::ceil(count * quantile) + 1);
  while (high <= count && cdf(complement(below, high - 1)) > beyond) ++high;
  if (low < 1 || high > count) return {};
  return QuantileInterval{sorted[static_cast<std::size_t>(low) - 1],
                          sorted[static_cast<std::size_t>(high) - 1]};
}

std::optional<double> half_width(const StopRule& rule, const std::vector<double>& values) {
  std::vector<double> sorted;
  for (const double value : values) {
    if (std::isfinite(value)) sorted.push_back(value);
  }
  if (sorted.empty()) return {};
  if (rule.of == share_completed) {
    const auto completed = static_cast<std::size_t>(std::ranges::count(sorted, 1.0));
    const ShareInterval interval = share_interval(completed, sorted.size());
    return (interval.high - interval.low) / 2;
  }
  std::ranges::sort(sorted);
  const auto interval = quantile_interval(sorted, rule.quantile.value_or(0.5));
  if (!interval) return {};
  return (interval->high - interval->low) / 2;
}

void check_stop_rule(const Study& study, Faults& faults) {
  if (!study.stop_when) return;
  const StopRule& rule = *study.stop_when;
  if (study.sampling == Sampling::latin_hypercube || study.sampling == Sampling::grid) {
    faults.error(rule.place,
                 fmt::format("stop_when: a part of a sampling '{}' is no sample of the whole; of "
                             "'random' and 'sobol' it is",
                             to_string(study.sampling)));
  }
  std::vector<std::string> names{share_completed};
  for (const Gathering& gathering : study.gathered) names.push_back(gathering.name);
  if (std::ranges::find(names, rule.of) != names.end()) return;
  faults.error(rule.place,
               fmt::format("stop_when: of = '{}': nothing of that name is gathered{}; there are {}",
                           rule.of, did_you_mean(rule.of, names), fmt::join(names, ", ")));
}

}  // namespace lsos
