// The line that a rover drives through its waypoints: gentle corners rounded by arcs, sharp ones
// kept as places to stop and turn on the spot, and how fast it may pass each point.
#pragma once

#include <vector>

#include "base/vector.h"

namespace lsos {

struct DrivingLimits {
  double speed_mps = 1;            // greatest along the line
  double acceleration_mps2 = 0.2;  // along the line, both ways
  double lateral_mps2 = 0.2;       // across it, in arcs
  double corner_offset_m = 0.2;    // how far an arc may pass inside its corner
  double radius_min_m = 5;         // of an arc
  bool can_turn_on_spot = true;
};

// One straight piece of the line; arcs are pieces of at most 0.1 rad each. Horizontal plane of S.
struct DrivingLeg {
  Vec2 from_S_m, along_S;  // along_S: unit
  double length_m = 0;
  double begin_m = 0;        // distance along the line
  double curvature_1pm = 0;  // of the arc it belongs to, to the left positive
  double speed_max_mps = 0;  // on this leg
  double end_speed_mps = 0;  // at its end, so that all that follows can be kept
  bool ends_in_stop = false;
};

// Waypoints nearer than 1 cm to the one before are left out; fewer than two leave no legs.
std::vector<DrivingLeg> driving_line(const std::vector<Vec2>& waypoints_S_m,
                                     const DrivingLimits& limits);

}  // namespace lsos
