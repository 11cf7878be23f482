// Speed limits from the side slip angle, which is the angle between travel and heading. It arises
// where wheels need a slip angle to produce side force: on cross slopes and in arcs.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace lsos {

// Magnitude of the side slip angle at a lateral acceleration of either sign. The side force of
// wheels in soil rises with their slip angle b to a greatest one, as shear stress does with shear
// (Janosi and Hanamoto 1961):
//  F = F_max (1 - exp(-C b / F_max)),  side_slip_s2pm = m / C,  side_grip_mps2 = F_max / m.
// Above 0.95 of the grip the angle stays the same: limits on slope end a route before that.
inline double side_slip_rad(double lateral_mps2, double side_slip_s2pm, double side_grip_mps2) {
  constexpr double used_max = 0.95;
  const double used = std::min(used_max, std::abs(lateral_mps2) / side_grip_mps2);
  return -side_slip_s2pm * side_grip_mps2 * std::log1p(-used);
}

// Limit on speed times the square root of the side slip angle. The slip angle changes with the
// cross slope, and until the heading has followed, the rover leaves its line by a distance that
// grows with the slip angle and with the speed. With this value LRV, fast on four narrow wheels,
// keeps within 0.5 m of its lines over the ground about the lunar south pole (the test
// PlannedTurns); without the limit its cross-track error exceeded 1.5 m.
inline constexpr double side_slip_limit_mps = 0.35;

// Highest speed at a side slip angle of either sign; infinite at 0.
inline double side_slip_speed_mps(double angle_rad) {
  if (angle_rad == 0) return std::numeric_limits<double>::infinity();
  return side_slip_limit_mps / std::sqrt(std::abs(angle_rad));
}

// The same limit in an arc, whose lateral acceleration is v^2 / R; infinite without side slip. By
// iteration over the angle per lateral acceleration b / a at the last speed:
//  v^4 = side_slip_limit_mps^2 R / (b / a).
inline double side_slip_arc_speed_mps(double radius_m, double side_slip_s2pm,
                                      double side_grip_mps2) {
  if (side_slip_s2pm <= 0) return std::numeric_limits<double>::infinity();
  constexpr int iterations = 4;
  double per_lateral_s2pm = side_slip_s2pm, speed2 = 0;
  for (int k = 0; k < iterations; ++k) {
    speed2 = side_slip_limit_mps * std::sqrt(radius_m / per_lateral_s2pm);
    const double lateral_mps2 = speed2 / radius_m;
    per_lateral_s2pm = side_slip_rad(lateral_mps2, side_slip_s2pm, side_grip_mps2) / lateral_mps2;
  }
  return std::sqrt(speed2);
}

}  // namespace lsos
