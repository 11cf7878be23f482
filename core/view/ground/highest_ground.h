// Bounds on the height of ground, and what follows from them for rays.
#pragma once

#include <algorithm>
#include <cmath>

#include "planet/site_frame.h"

namespace lsos {

// No ground of Moon, Mars or Earth lies as low, above the reference surface, m.
inline constexpr double lowest_ground_m = -12e3;

// Upper bound on the dip of the horizon below level: its dip seen from that height over the
// deepest ground of the body (12 km below its reference surface). `height_m`: above the reference
// surface.
inline double horizon_dip_rad(const Body& body, double height_m) {
  constexpr double deepest_m = -lowest_ground_m;
  const double radius_m = body.equatorial_radius_m - deepest_m;
  return std::acos(radius_m / (radius_m + std::max(0.0, height_m + deepest_m)));
}

// Whether the straight line between two points passes below all possible ground: the body itself
// stands between them.
inline bool passes_under_ground(const SiteFrame& site, const Vec3& from_S_m, const Vec3& to_S_m) {
  const Vec3 from_F_m = site.p_F_m(from_S_m), way_m = site.p_F_m(to_S_m) - from_F_m;
  const double length2 = way_m.squaredNorm();
  if (length2 <= 0) return false;
  const double share = std::clamp(-from_F_m.dot(way_m) / length2, 0.0, 1.0);
  return site.height_m(from_S_m + share * (to_S_m - from_S_m)) < lowest_ground_m;
}

}  // namespace lsos
