// Bounds of what a script in rovers/ lists.
#pragma once

#include <string>
#include <vector>

#include "base/shape.h"
#include "mission/model/antenna.h"
#include "power/power_spec.h"

namespace lsos {

// Parts of which there are too many, each of which costs time at each look, or that lie or reach so
// far that no picture holds them. One sentence each; empty if there are none.
std::vector<std::string> part_faults(const std::vector<Shape>& shapes, const PowerSpec& power,
                                     const std::vector<AntennaSpec>& antennas);

}  // namespace lsos
