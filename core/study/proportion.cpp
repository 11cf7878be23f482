#include "study/proportion.h"

#include <algorithm>
#include <cmath>

namespace lsos {

ShareInterval share_interval(std::size_t count, std::size_t cases) {
  constexpr double z = 1.959963984540054;  // of 95 % in the middle of a normal distribution
  if (cases == 0) return {};
  const auto n = static_cast<double>(cases);
  const double seen = static_cast<double>(count) / n, weight = 1 + z * z / n;
  const double middle = (seen + z * z / (2 * n)) / weight;
  const double half = z / weight * std::sqrt(seen * (1 - seen) / n + z * z / (4 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace lsos
