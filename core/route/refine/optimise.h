// Optimisation of a route off the lattice, by OMPL's PathSimplifier: shortcuts and perturbed poses
// while the cost falls. Dubins paths are only shortcut, by the cost of pieces begun at full speed,
// and the result is kept only if it is cheaper as a whole. None of OMPL's planners is used;
// README.md says why.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "route/refine/steering.h"

namespace lsos {

struct OptimisedRoute {
  Line2 line;
  std::vector<std::string> messages;  // OMPL's warnings
};

// What results depend on besides the arguments: loaded libraries and the processor.
std::string optimiser_stamp();

// Optimises a route over `poses`, two at least, that is free of hazards; it never gets costlier.
// The same seed gives the same bits: one call at a time runs in a process, since OMPL's random
// numbers are global to it.
OptimisedRoute optimise(RouteCost& costs, const RouteSteering& steering, std::vector<Pose2> poses,
                        std::uint64_t seed);
// The same for poses that shortcut() need not simplify first.
OptimisedRoute perturb(RouteCost& costs, const RouteSteering& steering,
                       const std::vector<Pose2>& poses, std::uint64_t seed);

}  // namespace lsos
