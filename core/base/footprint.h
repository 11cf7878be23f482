// The ground that a thing covers, seen from above: an upright rectangle round it, for telling
// whether two things touch.
#pragma once

#include "base/vector.h"

namespace lsos {

// In a horizontal plane: of the site frame, or of a map.
struct Footprint {
  Vec2 center_S_m = Vec2::Zero();
  Vec2 ahead_S = Vec2::UnitX();  // unit, along its length
  Vec2 half_m = Vec2::Zero();    // half of length and width
};

// A footprint whose reference point is the origin and that heads along x, moved to a place and
// heading (unit), and stretched along `reach_S_m`: what it covers on its way.
Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, const Vec2& ahead_S,
                const Vec2& reach_S_m = Vec2::Zero());
Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, double yaw_rad,
                const Vec2& reach_S_m = Vec2::Zero());

// How far apart they are along the axis that separates them best, m; less than 0 when they overlap.
double gap_m(const Footprint& a, const Footprint& b);
// From a place to its nearest point; 0 within it.
double distance_m(const Footprint& f, const Vec2& p_S_m);

// Touching counts.
bool overlap(const Footprint& a, const Footprint& b);

}  // namespace lsos
