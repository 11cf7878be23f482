#include "product/study/histogram.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "product/study/quantiles.h"

namespace lsos {

namespace {

constexpr std::size_t values_max = 12;         // that have a bar each
constexpr double bars_min = 5, bars_max = 40;  // of intervals, before their width is made round

// The least of 1, 2, 2.5, 5, 10, ... times a power of ten that is not below the width.
double round_width(double width) {
  const double decade = std::pow(10, std::floor(std::log10(width)));
  for (const double digit : {1.0, 2.0, 2.5, 5.0}) {
    if (digit * decade >= width * (1 - 1e-9)) return digit * decade;
  }
  return 10 * decade;
}

// `sorted`: two different values at least.
double width_of(const std::vector<double>& sorted) {
  const double span = sorted.back() - sorted.front();
  const double middle = quantile_of(sorted, 0.75) - quantile_of(sorted, 0.25);
  const double wanted = 2 * middle / std::cbrt(static_cast<double>(sorted.size()));
  return round_width(std::clamp(wanted, span / bars_max, span / bars_min));
}

std::vector<HistogramBar> empty_bars(const std::vector<double>& sorted) {
  std::vector<HistogramBar> bars;
  const std::set<double> distinct(sorted.begin(), sorted.end());
  const bool is_whole =
      std::ranges::all_of(distinct, [](double value) { return value == std::round(value); });
  if (distinct.size() <= 2 || (is_whole && distinct.size() <= values_max)) {
    for (const double value : distinct) bars.push_back({value, value});
    return bars;
  }
  const double width = width_of(sorted), first = std::floor(sorted.front() / width);
  const double last = std::max(first + 1, std::ceil(sorted.back() / width));
  for (double k = first; k < last; ++k) bars.push_back({k * width, (k + 1) * width});
  return bars;
}

}  // namespace

std::vector<HistogramBar> histogram(const std::vector<double>& values,
                                    const std::vector<bool>& is_completed) {
  std::vector<double> sorted;
  for (const double value : values) {
    if (std::isfinite(value)) sorted.push_back(value);
  }
  if (sorted.empty()) return {};
  std::ranges::sort(sorted);
  std::vector<HistogramBar> bars = empty_bars(sorted);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    // The last bar that begins at or before the value.
    const auto after = std::ranges::upper_bound(bars, values[i], {}, &HistogramBar::from);
    HistogramBar& bar = after == bars.begin() ? *after : *std::prev(after);
    ++(is_completed[i] ? bar.completed : bar.other);
  }
  return bars;
}

}  // namespace lsos
