// Lines over the meridian of 180 degrees.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "planet/body.h"

namespace lsos {

// The line with longitudes that go on beyond 180 degrees: with a jump of 360 viewers draw it the
// other way round the body.
inline std::vector<Geodetic> unrolled(std::vector<Geodetic> line) {
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double before_rad = line[k - 1].lon_rad, by_rad = line[k].lon_rad - before_rad;
    // Without a jump not a bit changes.
    if (std::abs(by_rad) <= std::numbers::pi) continue;
    line[k].lon_rad = before_rad + std::remainder(by_rad, 2 * std::numbers::pi);
  }
  return line;
}

}  // namespace lsos
