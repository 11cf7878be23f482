// Bounds on the height of ground, and what follows from them for rays.
#pragma once

#include <algorithm>
#include <cmath>

#include "planet/site_frame.h"

namespace lsos {

// Lower bound on the height of ground above the reference surface, m. 12 km is deeper than the
// basins of all bodies; the poles of Mars lie 20 km inside its sphere, as it is flattened.
inline double ground_bound_m(const Body& body) { return std::min(-12e3, body.lowest_ground_m); }

// Upper bound on the dip of the horizon below level: its dip seen from that height over ground at
// the lower bound. `height_m`: above the reference surface.
inline double horizon_dip_rad(const Body& body, double height_m) {
  const double deepest_m = -ground_bound_m(body);
  const double radius_m = body.equatorial_radius_m - deepest_m;
  return std::acos(radius_m / (radius_m + std::max(0.0, height_m + deepest_m)));
}

// Whether the straight line between two points passes below all possible ground: the body itself
// stands between them.
inline bool passes_under_ground(const SiteFrame& site, const Vec3& from_S_m, const Vec3& to_S_m) {
  const Vec3 from_F_m = site.p_F_m(from_S_m), line_m = site.p_F_m(to_S_m) - from_F_m;
  const double length2 = line_m.squaredNorm();
  if (length2 <= 0) return false;
  const double share = std::clamp(-from_F_m.dot(line_m) / length2, 0.0, 1.0);
  return site.height_m(from_S_m + share * (to_S_m - from_S_m)) < ground_bound_m(site.body());
}

}  // namespace lsos
