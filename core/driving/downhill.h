// How fast a rover is driven down a slope, where gravity takes a share of what its brakes can do.
#pragma once

#include <algorithm>
#include <cmath>

namespace lsos {

// Of its weight, what brakes of a rover are counted on for: four fifths of what `lsos-host rig`
// says of LRV's wheel on ApolloNominal at a slip of -0.25, which is 0.56.
inline constexpr double braking_grip = 0.45;
// Of what it slows down by at most, on slopes that leave less.
inline constexpr double braking_least = 0.2;

// Of the ground under a rover: the rise along its travel, up positive, and across it, either sign.
struct Incline {
  double pitch_rad = 0, bank_rad = 0;
};

// What it can count on to slow down by, at most `most_mps2`: of the grip on a circle, less what
// holds it across the slope and along it.
inline double braking_mps2(const Incline& ground, double most_mps2, double gravity_mps2) {
  const double up = std::sin(ground.pitch_rad), across = std::sin(ground.bank_rad);
  const double grip2 = braking_grip * braking_grip * (1 - up * up - across * across);
  const double left_mps2 = gravity_mps2 * (std::sqrt(std::max(0.0, grip2 - across * across)) + up);
  return std::clamp(left_mps2, braking_least * most_mps2, most_mps2);
}

// So that it stops on as short a way as on the level from `full_mps`. Without it LRV slid 0.6 m off
// lines down 17 degrees about the lunar south pole (the test PlannedTurns).
inline double downhill_speed_mps(const Incline& ground, double full_mps, double most_mps2,
                                 double gravity_mps2) {
  const double level_mps2 = braking_mps2({}, most_mps2, gravity_mps2);
  const double here_mps2 = braking_mps2(ground, most_mps2, gravity_mps2);
  return full_mps * std::sqrt(std::min(1.0, here_mps2 / level_mps2));
}

}  // namespace lsos
