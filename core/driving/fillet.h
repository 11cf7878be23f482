// Fillets: arcs that round the corners of a driving line. A corner without room for an arc is
// driven by stopping and turning on the spot.
#pragma once

#include <algorithm>
#include <cmath>

namespace lsos {

// Greatest distance between a corner and the fillet that rounds it. Larger: smoother and faster
// lines that pass farther from the waypoints.
inline constexpr double fillet_offset_m = 0.1;
// Rate at which wheels steer from straight into an arc, in 1/m per second, and the greatest
// distance driven meanwhile.
inline constexpr double curvature_rate_1pms = 0.2, steering_distance_m = 0.5;
// Time that wheels are given to follow when they are steered at rest, before the rover backs up.
inline constexpr double steering_lag_s = 1;

// Radius of the widest arc that is tangent to both sides of a corner, with half = bend_rad / 2:
//  it passes   R (1/cos(half) - 1)  inside the corner, `offset_m` at most,
//  it begins   R tan(half)          before the corner, `room_m` at most.
// `bend_rad` is the change of direction at the corner, above 0.
inline double fillet_radius_m(double bend_rad, double room_m, double offset_m) {
  const double half = bend_rad / 2;
  return std::min(offset_m / (1 / std::cos(half) - 1), room_m / std::tan(half));
}

// Speed on the arc: limited by the lateral acceleration, v^2 / R, and by the distance that steering
// into the arc takes, v / (R curvature_rate_1pms).
inline double arc_speed_mps(double radius_m, double speed_mps, double lateral_mps2,
                            double steering_m = steering_distance_m) {
  return std::min(
      {speed_mps, std::sqrt(lateral_mps2 * radius_m), steering_m * curvature_rate_1pms * radius_m});
}

}  // namespace lsos
