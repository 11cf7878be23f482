// The ground that an object covers, seen from above: a rectangle around it, used to detect that two
// objects touch.
#pragma once

#include "base/vector.h"

namespace lsos {

// Lies in a horizontal plane: that of the site frame, or of a map.
struct Footprint {
  Vec2 center_S_m = Vec2::Zero();
  Vec2 ahead_S = Vec2::UnitX();  // unit vector along the length
  Vec2 half_m = Vec2::Zero();    // half of length and width
};

// Moves a footprint, whose reference point is at the origin and which heads along x, to a position
// and heading (unit vector). `travel_S_m` stretches it to what it covers while it travels that far.
Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, const Vec2& ahead_S,
                const Vec2& travel_S_m = Vec2::Zero());
Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, double yaw_rad,
                const Vec2& travel_S_m = Vec2::Zero());

// Distance along the separating axis with the widest gap, m; negative when they overlap.
double gap_m(const Footprint& a, const Footprint& b);
// Distance from a point to the nearest point of the footprint; 0 inside it.
double distance_m(const Footprint& f, const Vec2& p_S_m);

// Touching counts as overlap.
bool overlap(const Footprint& a, const Footprint& b);

}  // namespace lsos
