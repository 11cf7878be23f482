// How high and how deep ground may be: rays above it meet none, and from it no lower ray leaves.
#pragma once

#include <algorithm>
#include <cmath>

#include "planet/site_frame.h"

namespace lsos {

// No ground of Moon, Mars or Earth lies as low, above the reference surface, m.
inline constexpr double lowest_ground_m = -12e3;

// How far below level the horizon may lie: even from so high over the deepest ground of the body
// (12 km below its reference surface) nothing lower is seen. `height_m`: above the reference
// surface.
inline double horizon_dip_rad(const Body& body, double height_m) {
  constexpr double deepest_m = -lowest_ground_m;
  const double radius_m = body.equatorial_radius_m - deepest_m;
  return std::acos(radius_m / (radius_m + std::max(0.0, height_m + deepest_m)));
}

// Whether a line passes under all ground that there may be: the body itself stands between.
inline bool passes_under_ground(const SiteFrame& site, const Vec3& from_S_m, const Vec3& to_S_m) {
  const Vec3 from_F_m = site.p_F_m(from_S_m), way_m = site.p_F_m(to_S_m) - from_F_m;
  const double length2 = way_m.squaredNorm();
  if (length2 <= 0) return false;
  const double share = std::clamp(-from_F_m.dot(way_m) / length2, 0.0, 1.0);
  return site.height_m(from_S_m + share * (to_S_m - from_S_m)) < lowest_ground_m;
}

}  // namespace lsos
