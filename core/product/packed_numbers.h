// Numbers of a page as base64 text: little-endian, as in browsers.
#pragma once

#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "base/base64.h"

namespace lsos {

// Whole numbers are rounded from `per_unit` times the values, which must then be finite.
template <class Number>
std::string packed(const std::vector<double>& values, double per_unit = 1) {
  std::string bytes(values.size() * sizeof(Number), '\0');
  for (std::size_t k = 0; k < values.size(); ++k) {
    Number number{};
    if constexpr (std::is_integral_v<Number>) {
      number = static_cast<Number>(std::llround(values[k] * per_unit));
    } else {
      number = static_cast<Number>(values[k] * per_unit);
    }
    std::memcpy(bytes.data() + k * sizeof number, &number, sizeof number);
  }
  return base64(bytes);
}

}  // namespace lsos
