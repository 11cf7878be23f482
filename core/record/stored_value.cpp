#include "record/stored_value.h"

#include <cmath>

#include "base/utf8.h"

namespace lsos {

bool is_within(const ColumnLimits& limits, double number) {
  return number >= limits.least && number <= limits.greatest;
}

bool hold_to(const ColumnLimits& limits, ColumnValue& value) {
  bool is_held = true;
  if (const auto* real = std::get_if<double>(&value)) {
    is_held = is_within(limits, *real);
  } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    is_held = is_within(limits, static_cast<double>(*integer));
  } else if (auto* text = std::get_if<std::string>(&value)) {
    if (!is_utf8(*text) || text->find('\0') != std::string::npos) *text = utf8_text(*text);
  }
  if (!is_held) value = {};
  return is_held;
}

bool is_place(double lon_deg, double lat_deg, double height_m) {
  constexpr double height_max_m = 1e9;
  constexpr double rounding_deg = 1e-9;
  return std::abs(lon_deg) <= 180 + rounding_deg && std::abs(lat_deg) <= 90 + rounding_deg &&
         std::abs(height_m) <= height_max_m;
}

}  // namespace lsos
