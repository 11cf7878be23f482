// Speed limits from the side slip angle, which is the angle between travel and heading. It arises
// where wheels need a slip angle to produce side force: on cross slopes and in arcs.
#pragma once

#include <cmath>
#include <limits>

namespace lsos {

// Limit on speed times the square root of the side slip angle. The slip angle changes with the
// cross slope, and until the heading has followed, the rover leaves its line by a distance that
// grows with the slip angle and with the speed. With this value LRV, fast on four narrow wheels,
// keeps within 0.5 m of its lines over the ground about the lunar south pole (the test
// PlannedTurns); without the limit its cross-track error exceeded 1.5 m.
inline constexpr double side_slip_limit_mps = 0.35;

// Highest speed at a side slip angle of either sign; infinite at 0.
inline double side_slip_speed_mps(double side_slip_rad) {
  if (side_slip_rad == 0) return std::numeric_limits<double>::infinity();
  return side_slip_limit_mps / std::sqrt(std::abs(side_slip_rad));
}

// The same limit in an arc, for a rover whose side slip angle is `side_slip_s2pm` rad per m/s2 of
// lateral acceleration:
//  slip angle = side_slip_s2pm v^2 / R,  v^4 = side_slip_limit_mps^2 R / side_slip_s2pm.
inline double side_slip_arc_speed_mps(double radius_m, double side_slip_s2pm) {
  if (side_slip_s2pm <= 0) return std::numeric_limits<double>::infinity();
  return std::pow(side_slip_limit_mps * side_slip_limit_mps * radius_m / side_slip_s2pm, 0.25);
}

}  // namespace lsos
