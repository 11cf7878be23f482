// Share of a disc's area on one side of a straight line.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

// The share on the centre's side. `offset`: distance from the line to the centre in radii, negative
// where the centre lies beyond it; a line that misses the disc leaves all or nothing.
inline double disc_share(double offset) {
  const double t = std::clamp(offset, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
}

}  // namespace lsos
