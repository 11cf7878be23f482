// A plan's Variant: changes to the numbers of a rover's script, as a planner writes them.
#pragma once

#include <string>

#include "base/parsed.h"

namespace lsos {

// "battery.capacity_j = 60 kWh; panels.Roof.efficiency = 0.32; can_crab = false": keys of the
// rover's script, those of its parts behind a point, each with a number (with a unit of the key's
// kind, else in the key's own), true, false or a text in quotes. The answer is the table of
// lsos.derive in Lua.
Parsed<std::string> variant_table(const std::string& text);

}  // namespace lsos
