#include "base/rounded_distance.h"

#include <fmt/format.h>

namespace lsos {

std::string rounded_distance(double distance_m) {
  if (distance_m < 999.5) return fmt::format("{:.0f} m", distance_m);
  return fmt::format("{:.{}f} km", distance_m / 1000, distance_m < 9950 ? 1 : 0);
}

}  // namespace lsos
