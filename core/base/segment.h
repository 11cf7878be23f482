// Straight pieces of a line: the bend from one to the next, and how far places are from one.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vector.h"

namespace lsos {

// z component of a x b: positive where b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Change of direction from one piece to the next, -pi..pi, positive to the left.
inline double bend_rad(const Vec2& in, const Vec2& out) {
  return std::atan2(cross(in, out), in.dot(out));
}

// Place of the segment from a to b that is nearest to p, as a share 0..1 of its length. Points are
// all Vec2 or all Vec3.
template <class Point>
double nearest_share(const Point& a_m, const Point& b_m, const Point& p_m) {
  const Point along_m = b_m - a_m;
  const double length2_m2 = along_m.squaredNorm();
  return length2_m2 > 0 ? std::clamp((p_m - a_m).dot(along_m) / length2_m2, 0.0, 1.0) : 0;
}

// Shortest distance from p to the segment from a to b.
template <class Point>
double point_distance_m(const Point& a_m, const Point& b_m, const Point& p_m) {
  return (p_m - a_m - nearest_share(a_m, b_m, p_m) * (b_m - a_m)).norm();
}

}  // namespace lsos
