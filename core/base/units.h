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

// Exact where the factor is the reciprocal of a short decimal number: 35 cm is 0.35 m.
double to_si(double value, const Unit& unit);
double from_si(double value_si, const Unit& unit);

}  // namespace lsos
