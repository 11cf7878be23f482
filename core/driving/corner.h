// Corners of a line that is driven: by an arc where there is room for one, else by stopping and
// turning on the spot.
#pragma once

#include <algorithm>
#include <cmath>

namespace lsos {

// How far the arc may pass inside its corner.
inline constexpr double corner_offset_m = 0.1;
// How fast wheels steer from straight into an arc, in 1/m a second, and over how long a way at
// most.
inline constexpr double curvature_rate_1pms = 0.2, steering_way_m = 0.5;

// Radius of the widest arc that touches both sides of a corner: it passes R (1/cos - 1) inside it
// and begins R tan before it, `room_m` at most. `bend_rad`: of the line there, above 0.
inline double corner_radius_m(double bend_rad, double room_m, double offset_m) {
  const double half = bend_rad / 2;
  return std::min(offset_m / (1 / std::cos(half) - 1), room_m / std::tan(half));
}

// How fast it is driven, with no more than so much acceleration across.
inline double arc_speed_mps(double radius_m, double speed_mps, double lateral_mps2) {
  return std::min({speed_mps, std::sqrt(lateral_mps2 * radius_m),
                   steering_way_m * curvature_rate_1pms * radius_m});
}

}  // namespace lsos
