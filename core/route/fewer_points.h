// A line made cheaper by leaving out points.
#pragma once

#include "route/leg_cost.h"

namespace lsos {

// The cheapest line through points of `line`, in their order, from the first to the last. Corners
// count: a stop less may be worth a longer way. Points between its own are tried too, so that a
// sharp corner may become two gentle ones. Never costs more than `line`.
Line2 with_fewer_points(LegCosts& costs, const Line2& line);

}  // namespace lsos
