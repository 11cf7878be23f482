// How high and how deep ground may be: rays above it meet none, and from it no lower ray leaves.
#pragma once

#include <algorithm>
#include <cmath>

#include "planet/body.h"

namespace lsos {

// The highest ground of the body above its reference surface, m.
inline double highest_ground_m(const Body& body) {
  if (body.name == "Moon") return 10800;
  if (body.name == "Mars") return 21300;
  return 8900;
}

// How far below level the horizon may lie: even from so high over the deepest ground of the body
// (12 km below its reference surface) nothing lower is seen. `height_m`: above the reference
// surface.
inline double horizon_dip_rad(const Body& body, double height_m) {
  constexpr double deepest_m = 12000;
  const double radius_m = body.equatorial_radius_m - deepest_m;
  return std::acos(radius_m / (radius_m + std::max(0.0, height_m + deepest_m)));
}

}  // namespace lsos
