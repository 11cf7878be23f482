// A route made cheaper by leaving out poses.
#pragma once

#include "route/refine/steering.h"

namespace lsos {

// The cheapest route through some of `poses` and of others between them, in their order, from the
// first to the last. Corners count: a stop less may be worth a longer way. In turns by the cheapest
// way to each pose and the speed that it is come to with. Looked for among pieces
// that pass over a few poses, then over what is left of them by four times as long ones, and so
// on: the work grows as the length and its logarithm. Never costs more than the route over `poses`.
std::vector<Pose2> with_fewer_poses(LegCosts& costs, const RouteSteering& steering,
                                    std::vector<Pose2> poses);

}  // namespace lsos
