#include "base/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lsos {

namespace {

Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

// Half of the footprint's extent along a unit vector.
double reach_m(const Footprint& f, const Vec2& along_S) {
  return f.half_m.x() * std::abs(f.ahead_S.dot(along_S)) +
         f.half_m.y() * std::abs(left_of(f.ahead_S).dot(along_S));
}

}  // namespace

Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, const Vec2& ahead_S,
                const Vec2& travel_S_m) {
  Footprint f;
  f.ahead_S = ahead_S;
  f.center_S_m = p_S_m + at_rest.center_S_m.x() * f.ahead_S +
                 at_rest.center_S_m.y() * left_of(f.ahead_S) + travel_S_m / 2;
  f.half_m =
      at_rest.half_m +
      Vec2(std::abs(travel_S_m.dot(f.ahead_S)), std::abs(travel_S_m.dot(left_of(f.ahead_S)))) / 2;
  return f;
}

Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, double yaw_rad,
                const Vec2& travel_S_m) {
  return moved(at_rest, p_S_m, Vec2(std::cos(yaw_rad), std::sin(yaw_rad)), travel_S_m);
}

double gap_m(const Footprint& a, const Footprint& b) {
  const Vec2 between_m = b.center_S_m - a.center_S_m;
  double widest_m = -std::numeric_limits<double>::infinity();
  for (const Vec2& axis : {a.ahead_S, left_of(a.ahead_S), b.ahead_S, left_of(b.ahead_S)}) {
    widest_m =
        std::max(widest_m, std::abs(between_m.dot(axis)) - reach_m(a, axis) - reach_m(b, axis));
  }
  return widest_m;
}

double distance_m(const Footprint& f, const Vec2& p_S_m) {
  const Vec2 from_m = p_S_m - f.center_S_m;
  const Vec2 aside_m(std::abs(from_m.dot(f.ahead_S)) - f.half_m.x(),
                     std::abs(from_m.dot(left_of(f.ahead_S))) - f.half_m.y());
  return aside_m.cwiseMax(0).norm();
}

bool overlap(const Footprint& a, const Footprint& b) { return gap_m(a, b) <= 0; }

}  // namespace lsos
