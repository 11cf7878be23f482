// Units of the outside world. All computation is in SI; conversion happens only here, called by the
// readers of plans and scripts and by the code that prints for people.
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/sim_time.h"

namespace lsos {

// Used in messages and maps; everywhere else angles are radians.
constexpr double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }
constexpr double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180; }

// One unit: value_si = value * si_factor. `kind` names the dimension ("speed", "length", ...); only
// units of one kind convert into each other. `suffix` ends the names of values in SI ("mps" in
// speed_mps).
struct Unit {
  std::string_view symbol;
  std::string_view kind;
  std::string_view suffix;
  double si_factor = 1;
};

// Finds "m/s", "deg", "s", "kWh", "1", ... ; nullptr when there is no such unit.
const Unit* find_unit(std::string_view symbol);
std::span<const Unit> all_units();

// A value, or the reason why there is none ("'fast' is no number; a speed is allowed, such as '2
// m/s'").
double to_si(double value, const Unit& unit);
double from_si(double value_si, const Unit& unit);

}  // namespace lsos
