// The line that a rover drives through its waypoints, with the greatest speed at each point. Gentle
// corners are rounded by fillets; at sharp ones the rover stops and turns on the spot.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vector.h"
#include "driving/fillet.h"

namespace lsos {

struct DrivingLimits {
  double speed_mps = 1;            // greatest along the line
  double acceleration_mps2 = 0.2;  // along the line, speeding up and slowing down
  double lateral_mps2 = 0.2;       // across the line, in arcs
  double radius_min_m = 5;         // least radius of an arc
  bool can_turn_on_spot = true;
  // Greatest distance of a corner from its fillet, and that driven while steering into an arc.
  double corner_offset_m = fillet_offset_m, steering_m = steering_distance_m;
};

// One straight piece of the line, in the horizontal plane of S; an arc consists of pieces of at
// most 0.1 rad each.
struct DrivingPiece {
  Vec2 from_S_m, along_S;  // along_S: unit
  double length_m = 0;
  double begin_m = 0;        // distance of its beginning along the line
  double curvature_1pm = 0;  // curvature of the arc it belongs to, left positive
  double speed_max_mps = 0;  // on this piece
  double end_speed_mps = 0;  // at its end, low enough for all that follows
  bool ends_in_stop = false;
  bool is_backward = false;  // the rover backs up along it
};

// Waypoints within 1 cm of the previous one are left out; fewer than two give an empty line.
// `gear_changes`: indices of waypoints, ascending, at which the rover stops and changes between
// forwards and backwards; 0: it begins backwards.
std::vector<DrivingPiece> driving_line(const std::vector<Vec2>& waypoints_S_m,
                                       const DrivingLimits& limits,
                                       const std::vector<std::size_t>& gear_changes = {});

}  // namespace lsos
