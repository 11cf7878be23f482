#include "product/study/quantiles.h"

#include <algorithm>
#include <cmath>

namespace lsos {

double quantile_of(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Quantiles quantiles_of(std::vector<double>& values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {quantile_of(values, 0.05), quantile_of(values, 0.5), quantile_of(values, 0.95),
          values.size()};
}

}  // namespace lsos
