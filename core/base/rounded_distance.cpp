#include "base/rounded_distance.h"

#include <fmt/format.h>

#include <cmath>

namespace lsos {

std::string rounded_distance(double distance_m) {
  if (distance_m < 9.5) return fmt::format("{:.0f} m", distance_m);
  const double digit_m = std::pow(10, std::floor(std::log10(distance_m)) - 1);
  const double rounded_m = std::round(distance_m / digit_m) * digit_m;
  if (rounded_m < 1000) return fmt::format("{:.0f} m", rounded_m);
  return fmt::format("{:.{}f} km", rounded_m / 1000, rounded_m < 10e3 ? 1 : 0);
}

}  // namespace lsos
