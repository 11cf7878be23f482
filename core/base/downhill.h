// How fast a rover is driven down a slope, where gravity takes a share of what its brakes can do.
#pragma once

#include <algorithm>
#include <cmath>

namespace lsos {

// Of its weight, what loose soil holds a rover's wheels with that brakes slow by a fourth of their
// spin: `lsos-host rig` says 0.41 at slip -0.2 and 0.53 at -0.3 for LRV on ApolloNominal.
inline constexpr double braking_grip = 0.45;
// Of what it slows down by on the level; steeper slopes it only creeps down.
inline constexpr double braking_least = 0.2;

// What it can count on to slow down by: at most what it speeds up by. Pitch: nose up, any angle.
inline double braking_mps2(double pitch_rad, double acceleration_mps2, double gravity_mps2) {
  const double left_mps2 =
      gravity_mps2 * (braking_grip * std::cos(pitch_rad) + std::sin(pitch_rad));
  return std::clamp(left_mps2, braking_least * acceleration_mps2, acceleration_mps2);
}

// So that it stops on as short a way as on the level from full speed. Without it LRV slid 0.6 m off
// lines down 17 degrees about the lunar south pole (the test PlannedTurns).
inline double downhill_speed_mps(double pitch_rad, double speed_mps, double acceleration_mps2,
                                 double gravity_mps2) {
  return speed_mps *
         std::sqrt(braking_mps2(pitch_rad, acceleration_mps2, gravity_mps2) / acceleration_mps2);
}

}  // namespace lsos
