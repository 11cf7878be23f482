// Reads a plan's Variant: changes to the numbers of a rover's script, as a planner writes them.
#pragma once

#include <string>

#include "base/parsed.h"

namespace lsos {

// Reads "battery.capacity_j = 60 kWh; panels.Roof.efficiency = 0.32; can_crab = false": keys of the
// rover's script, those of its parts behind a point, each with a number (in a unit of the key's
// kind, or in the key's own unit if none is given), true, false or a text in quotes. Returns the
// table of lsos.derive in Lua.
Parsed<std::string> variant_table(const std::string& text);

}  // namespace lsos
