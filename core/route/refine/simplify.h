// Simplification of lines: removes points at which a line bends hardly or not at all.
#pragma once

#include "route/cost/route_cost.h"

namespace lsos {

// Without the points that lie on the straight between their neighbours.
Line2 corners(const Line2& line);

}  // namespace lsos
