#include "study/first_order.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <map>

#include "study/rank_correlation.h"

namespace lsos {

namespace {

struct Sums {
  double sum = 0;
  std::size_t count = 0;
  double mean() const { return sum / static_cast<double>(count); }
};

// The probability that chance alone gives classes whose means differ so much.
double variance_significance(double between, double within, double between_freedom,
                             double within_freedom) {
  if (!(within > 0)) return 0;
  const double ratio = (between / between_freedom) / (within / within_freedom);
  const boost::math::fisher_f_distribution<double> expected(between_freedom, within_freedom);
  return cdf(complement(expected, ratio));
}

}  // namespace

std::vector<std::size_t> classes_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const auto classes_max = std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(count)));
  std::map<double, std::size_t> distinct;
  for (const double value : values) distinct.emplace(value, 0);
  std::vector<std::size_t> classes;
  if (distinct.size() <= classes_max) {
    std::size_t next = 0;
    for (auto& [value, number] : distinct) number = next++;
    for (const double value : values) classes.push_back(distinct.at(value));
    return classes;
  }
  for (const double rank : average_ranks(values)) {
    classes.push_back(
        static_cast<std::size_t>((rank - 0.5) / count * static_cast<double>(classes_max)));
  }
  return classes;
}

std::optional<FirstOrderShare> first_order_share(const std::vector<std::size_t>& classes,
                                                 const std::vector<double>& result) {
  std::map<std::size_t, Sums> by_class;
  Sums all;
  for (std::size_t i = 0; i < std::min(classes.size(), result.size()); ++i) {
    if (!std::isfinite(result[i])) continue;
    for (Sums* sums : {&by_class[classes[i]], &all}) {
      sums->sum += result[i];
      ++sums->count;
    }
  }
  if (all.count < first_order_cases_min || by_class.size() < 2 || by_class.size() >= all.count) {
    return {};
  }
  double total = 0, within = 0;
  for (std::size_t i = 0; i < std::min(classes.size(), result.size()); ++i) {
    if (!std::isfinite(result[i])) continue;
    const double from_class = result[i] - by_class.at(classes[i]).mean();
    const double from_all = result[i] - all.mean();
    within += from_class * from_class;
    total += from_all * from_all;
  }
  if (!(total > 0)) return {};
  const auto between_freedom = static_cast<double>(by_class.size() - 1);
  const auto within_freedom = static_cast<double>(all.count - by_class.size());
  const double all_freedom = between_freedom + within_freedom;
  FirstOrderShare found;
  // Both variances without their bias: what is left of 1 is what the classes explain.
  found.share = std::clamp(1 - (within / within_freedom) / (total / all_freedom), 0.0, 1.0);
  found.p = variance_significance(total - within, within, between_freedom, within_freedom);
  found.classes = by_class.size();
  found.cases = all.count;
  return found;
}

}  // namespace lsos
