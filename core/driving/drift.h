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
inline constexpr double drift_pace_mps = 0.35;

// Highest speed at a side slip angle of either sign; infinite at 0.
inline double drift_speed_mps(double drift_rad) {
  if (drift_rad == 0) return std::numeric_limits<double>::infinity();
  return drift_pace_mps / std::sqrt(std::abs(drift_rad));
}

// The same limit in an arc, for a rover whose side slip angle is `drift_s2pm` rad per m/s2 of
// lateral acceleration:
//  slip angle = drift_s2pm v^2 / R,  v^4 = drift_pace_mps^2 R / drift_s2pm.
inline double drift_arc_speed_mps(double radius_m, double drift_s2pm) {
  if (drift_s2pm <= 0) return std::numeric_limits<double>::infinity();
  return std::pow(drift_pace_mps * drift_pace_mps * radius_m / drift_s2pm, 0.25);
}

}  // namespace lsos
