#include "product/quantity_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace lsos {

namespace {

// The unit in which a quantity with that suffix is shown if its value is at least `least`.
struct ShownUnit {
  std::string_view suffix;
  double least = 0;   // in the unit of the name
  double factor = 1;  // units of the name per shown unit
  std::string_view unit;
};
constexpr double hour_s = 3600, minute_s = 60, kilo = 1000;
// The larger unit comes first.
constexpr ShownUnit shown_units[] = {
    {"_m", kilo, kilo, " km"},    {"_m", 0, 1, " m"},
    {"_s", hour_s, hour_s, " h"}, {"_s", minute_s, minute_s, " min"},
    {"_s", 0, 1, " s"},           {"_j", kilo* hour_s, kilo* hour_s, " kWh"},
    {"_j", 0, hour_s, " Wh"},     {"_w", kilo, kilo, " kW"},
    {"_w", 0, 1, " W"},           {"_rad", 0, std::numbers::pi / 180, "\u00b0"},
    {"_mps", 0, 1, " m/s"},       {"_slip", 0, 0.01, " %"},
    {"_share", 0, 0.01, " %"},
};

const ShownUnit* shown_unit(std::string_view name, double value) {
  const auto found = std::ranges::find_if(shown_units, [&](const ShownUnit& unit) {
    return name.ends_with(unit.suffix) && std::abs(value) >= unit.least;
  });
  return found == std::end(shown_units) ? nullptr : found;
}

}  // namespace

std::string quantity_label(const std::string& name) {
  std::string label = name;
  const ShownUnit* unit = shown_unit(name, 0);
  const bool is_word = unit != nullptr && unit->unit == " %";  // the suffix is a word of the name
  if (unit != nullptr && !is_word) label.resize(label.size() - unit->suffix.size());
  std::ranges::replace(label, '_', ' ');
  return label;
}

std::string quantity_text(const std::string& name, double value, int digits) {
  const ShownUnit* unit = shown_unit(name, value);
  if (unit == nullptr) return fmt::format("{:.{}g}", value, digits);
  const double shown = value / unit->factor;
  // Rather all whole digits than an exponent.
  const bool is_large = std::abs(shown) >= std::pow(10, digits) && std::abs(shown) < 1e9;
  if (is_large) return fmt::format("{:.0f}{}", shown, unit->unit);
  return fmt::format("{:.{}g}{}", shown, digits, unit->unit);
}

std::string change_text(const std::string& name, double change, int digits) {
  return (change < 0 ? "" : "+") + quantity_text(name, change, digits);
}

}  // namespace lsos
