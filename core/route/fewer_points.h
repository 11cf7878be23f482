// A line with points left out that it hardly bends at, or not at all.
#pragma once

#include "route/leg_cost.h"

namespace lsos {

// No point of `line` is farther than `off_m` from what is left of it (Douglas and Peucker 1973).
// Arcs stay as wide: what follows the line rounds its corners by as much as they are apart.
Line2 with_fewer_points(const Line2& line, double off_m);

// Without the points that lie on the straight between their neighbours.
Line2 corners(const Line2& line);

}  // namespace lsos
