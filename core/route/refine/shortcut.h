// Shortcuts: leaves out poses of a route to make it cheaper.
#pragma once

#include "route/refine/steering.h"

namespace lsos {

// Cheapest route through some of `poses` and of others between them, in their order, from the first
// to the last. Corners count: a longer route may be worth one stop less. For Dubins paths the
// cheapest route to each pose is kept, with the speed on arrival. Pieces that skip a few poses are
// tried first, then pieces four times as long over the poses left, and so on: the work grows as the
// length times its logarithm. The result never costs more than the route over `poses`.
std::vector<Pose2> shortcut(RouteCost& costs, const RouteSteering& steering,
                            std::vector<Pose2> poses);

}  // namespace lsos
