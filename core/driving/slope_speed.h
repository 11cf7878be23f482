// Slope speed: how fast a rover may drive down a slope, where gravity takes a share of its braking.
#pragma once

#include <algorithm>
#include <cmath>

namespace lsos {

// Coefficient of braking friction that a rover counts on, braking force over weight. It is two
// thirds of 0.67, which `lsos-host rig` gives for LRV's wheel on ApolloNominal at a slip of -0.25.
inline constexpr double braking_friction = 0.45;
// Least deceleration assumed on steep slopes, as a share of the greatest one.
inline constexpr double braking_share_min = 0.2;

// Inclination of the ground under a rover: along its travel, rising positive, and across it, either
// sign.
struct Incline {
  double pitch_rad = 0, bank_rad = 0;
};

// Deceleration that the rover can count on, at most `most_mps2`. On the friction circle the grip
// left along the travel is what remains after holding the rover across the slope, plus gravity's
// part along it (negative downhill):
//  g (sqrt(mu^2 cos^2(slope) - sin^2(bank)) + sin(pitch)),  mu = braking_friction.
inline double braking_mps2(const Incline& ground, double most_mps2, double gravity_mps2) {
  const double up = std::sin(ground.pitch_rad), across = std::sin(ground.bank_rad);
  const double grip2 = braking_friction * braking_friction * (1 - up * up - across * across);
  const double left_mps2 = gravity_mps2 * (std::sqrt(std::max(0.0, grip2 - across * across)) + up);
  return std::clamp(left_mps2, braking_share_min * most_mps2, most_mps2);
}

// Speed at which the stopping distance v^2 / (2 a) equals that from `level_speed_mps` on level
// ground. Without this limit LRV slid 0.6 m off its lines down 17 degrees about the lunar south
// pole (the test PlannedTurns).
inline double slope_speed_mps(const Incline& ground, double level_speed_mps, double most_mps2,
                              double gravity_mps2) {
  const double level_mps2 = braking_mps2({}, most_mps2, gravity_mps2);
  const double here_mps2 = braking_mps2(ground, most_mps2, gravity_mps2);
  return level_speed_mps * std::sqrt(std::min(1.0, here_mps2 / level_mps2));
}

}  // namespace lsos
