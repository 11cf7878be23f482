// Limits of a rover, given by its script, on the ground that planned routes may cross.
#pragma once

#include <optional>

namespace lsos {

// Absent limits follow from the rover's dimensions: 0.6 of the slope that tips it over, a slip of
// 0.6, 0.3 of its clearance, a wheel's radius of unevenness.
struct GroundLimits {
  std::optional<double> slope_max_rad;    // slope under its wheels, in any direction
  std::optional<double> slip_max;         // steady slip while climbing, 0..1
  std::optional<double> clearance_min_m;  // under the chassis
  // Distance of the ground at a wheel from the plane under the others.
  std::optional<double> unevenness_max_m;
};

}  // namespace lsos
