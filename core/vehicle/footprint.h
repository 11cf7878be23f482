// The ground that a vehicle covers, seen from above: an upright rectangle round its chassis and
// wheels, for telling whether two vehicles touch.
#pragma once

#include "base/vector.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Horizontal plane of the site frame.
struct Footprint {
  Vec2 center_S_m = Vec2::Zero();
  Vec2 ahead_S = Vec2::UnitX();  // unit, along its length
  Vec2 half_m = Vec2::Zero();    // half of length and width
};

// Of the vehicle with its reference point at the origin, heading along x, wheels straight ahead.
Footprint footprint_at_rest(const VehicleConfig& vehicle);

// That footprint moved to a pose, and stretched along `reach_S_m`: what it covers on its way.
Footprint moved(const Footprint& at_rest, const Vec2& p_S_m, double yaw_rad, const Vec2& reach_S_m);

// How far apart they are along the axis that separates them best, m; less than 0 when they overlap.
double gap_m(const Footprint& a, const Footprint& b);

// Touching counts.
bool overlap(const Footprint& a, const Footprint& b);

}  // namespace lsos
