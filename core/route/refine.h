// A route made better off the lattice, by OMPL: corners cut and poses moved while its cost falls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "route/turning_search.h"

namespace lsos {

struct Refined {
  Line2 line;
  std::vector<std::string> messages;  // OMPL's warnings
};

// Never costs more than `line`, which must be free of hazards. The same seed gives the same bits:
// one call at a time runs in a process, for OMPL's random numbers are the process' own.
Refined refined(LegCosts& costs, const Line2& line, std::uint64_t seed);

// The same for a rover that cannot turn on the spot: turns stay as wide as `radius_m`.
Refined refined(LegCosts& costs, const TurningRoute& route, double radius_m, std::uint64_t seed);

}  // namespace lsos
