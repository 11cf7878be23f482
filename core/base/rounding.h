// Numbers that stand for none, or for one beyond all others; rounding in tables and JSON.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace lsos {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
// What stands where a value is not known.
inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// The value, where it is known.
inline std::optional<double> if_known(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

// Rounded to that many decimals, so that 0.3 is not written 0.30000000000000004.
double with_decimals(double value, int decimals);
// To 12 decimals, which removes the error of turning a user's degrees into radians and back.
double entered_deg(double angle_deg);
// A computed value to 9 decimals: 1e-9 degrees, 1e-9 of a share, or a nanometre.
double computed(double value);

}  // namespace lsos
