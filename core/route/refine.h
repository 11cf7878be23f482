// A route made better off the lattice, by OMPL: corners cut and points moved while its cost falls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "route/leg_cost.h"

namespace lsos {

struct Refined {
  Line2 line;
  std::vector<std::string> messages;  // OMPL's warnings
};

// Never costs more than `line`, which must be free of hazards. The same seed gives the same bits:
// one call at a time runs in a process, for OMPL's random numbers are the process' own.
Refined refined(LegCosts& costs, const Line2& line, std::uint64_t seed);

}  // namespace lsos
