// Lines that cross the meridian of 180 degrees.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "planet/body.h"

namespace lsos {

// Returns the line with continuous longitudes, which may pass 180 degrees: viewers draw a jump of
// 360 degrees as a line around the other side of the body.
inline std::vector<Geodetic> unwrapped_longitudes(std::vector<Geodetic> line) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double before_rad = line[k - 1].lon_rad, by_rad = line[k].lon_rad - before_rad;
    // Longitudes without a jump keep their bits.
    if (std::abs(by_rad) <= std::numbers::pi) continue;
    line[k].lon_rad = before_rad + std::remainder(by_rad, 2 * std::numbers::pi);
  }
  return line;
}

}  // namespace lsos
