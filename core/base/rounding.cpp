#include "base/rounding.h"

#include <cmath>

namespace lsos {

double with_decimals(double value, int decimals) {
  const double scale = std::pow(10, decimals);
  constexpr double exact_max = 9e15;  // whole numbers below are exact
  if (!(std::abs(value) * scale < exact_max)) return value;
  const double rounded = std::round(value * scale) / scale;
  return rounded == 0 ? 0 : rounded;  // no -0
}

double entered_deg(double angle_deg) { return with_decimals(angle_deg, 12); }

double computed(double value) { return with_decimals(value, 9); }

}  // namespace lsos
