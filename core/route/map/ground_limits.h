// What a rover's script says of the ground that planned ways keep off.
#pragma once

#include <optional>

namespace lsos {

// What is absent follows from the rover's dimensions: 0.6 of the slope that tips it over, a slip of
// 0.6, 0.3 of its clearance, 0.6 of a wheel's radius.
struct GroundLimits {
  std::optional<double> slope_max_rad;    // under its wheels, in any direction
  std::optional<double> slip_max;         // steady, climbing, 0..1
  std::optional<double> clearance_min_m;  // under the chassis
  std::optional<double>
      unevenness_max_m;  // of the ground at a wheel from the plane under the others
};

}  // namespace lsos
