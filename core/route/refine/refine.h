// A route made better off the lattice, by OMPL's PathSimplifier: corners cut and poses moved while
// its cost falls. In turns corners alone are cut, by what pieces cost that are come to at full
// speed, and only what is cheaper as a whole is kept. Of its planners none is used: README.md says
// why.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "route/refine/steering.h"

namespace lsos {

struct Refined {
  Line2 line;
  std::vector<std::string> messages;  // OMPL's warnings
};

// What its results depend on beside its arguments: the libraries that are loaded, the processor.
std::string refining_stamp();

// A route over `poses`, two at least, that is free of hazards made cheaper; never costlier. The
// same seed gives the same bits: one call at a time runs in a process, for OMPL's random numbers
// are the process' own.
Refined refined(LegCosts& costs, const RouteSteering& steering, std::vector<Pose2> poses,
                std::uint64_t seed);
// The same of poses of which none need be left out before they are moved.
Refined moved(LegCosts& costs, const RouteSteering& steering, const std::vector<Pose2>& poses,
              std::uint64_t seed);

}  // namespace lsos
