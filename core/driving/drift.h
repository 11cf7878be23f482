// How fast a rover is driven where it drifts, which is travelling at an angle to its heading: side
// force across a slope or in an arc takes an angle of its wheels.
#pragma once

#include <cmath>
#include <limits>

namespace lsos {

// As the slope across changes so does the drift, and until the heading has followed the rover is
// carried off its line: the farther, the more it drifts and the faster it goes, by both. With this
// for speed times the root of drift LRV, fast on four narrow wheels, keeps within 0.5 m of lines
// over the ground about the lunar south pole (the test PlannedTurns); without it passed 1.5 m.
inline constexpr double drift_pace_mps = 0.35;

// Infinite without drift. Either sign.
inline double drift_speed_mps(double drift_rad) {
  if (drift_rad == 0) return std::numeric_limits<double>::infinity();
  return drift_pace_mps / std::sqrt(std::abs(drift_rad));
}

// The same in an arc, of a rover that drifts by `drift_s2pm` rad for each m/s2 across.
inline double drift_arc_speed_mps(double radius_m, double drift_s2pm) {
  if (drift_s2pm <= 0) return std::numeric_limits<double>::infinity();
  return std::pow(drift_pace_mps * drift_pace_mps * radius_m / drift_s2pm, 0.25);
}

}  // namespace lsos
