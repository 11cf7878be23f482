// Units of the outside world. Inside everything is SI; conversion happens here alone, called by
// the readers of plans and scripts and by what prints for people.
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/sim_time.h"

namespace lsos {

// For messages and maps; everywhere else angles are radians.
constexpr double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }
constexpr double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180; }

// One unit: value_si = value * si_factor. `kind` names the dimension ("speed", "length", ...);
// only units of one kind convert into each other. `suffix` is what a name in SI ends in ("_mps").
struct Unit {
  std::string_view symbol;
  std::string_view kind;
  std::string_view suffix;
  double si_factor = 1;
};

// "m/s", "deg", "s", "kWh", "1", ... ; nullptr when there is no such unit.
const Unit* find_unit(std::string_view symbol);
std::span<const Unit> all_units();

// A value, or why there is none ("'fast' is no number; a speed is allowed, such as '2 m/s'").
template <class T>
struct Parsed {
  std::optional<T> value;
  std::string why;

  explicit operator bool() const { return value.has_value(); }
};

// Reads "10", "10 km/h", "1.5h", "-3e2 m" in the C locale; a bare number is in `unit`. The answer
// is SI. Infinite and not-a-number values are refused. Durations also as ISO 8601 (PT1H30M, P2D).
Parsed<double> parse_quantity(std::string_view text, const Unit& unit);

// Reads a whole number.
Parsed<std::int64_t> parse_integer(std::string_view text);
// Reads true, false, 1, 0.
Parsed<bool> parse_boolean(std::string_view text);

// For people: value_si in `unit` with its symbol, shortest form that reads back equal: "2.5 km/h".
std::string format_quantity(double value_si, const Unit& unit);

}  // namespace lsos
