// Simplification of lines: removes points at which a line bends hardly or not at all.
#pragma once

#include <cstddef>
#include <vector>

#include "route/cost/stretch.h"

namespace lsos {

// Without the points that lie on the straight between their neighbours.
Line2 corners(const Line2& line);

// The corners of all stretches as one line, and the indices of its points at which the gear
// changes: 0 where the route begins backwards.
struct GearedLine {
  Line2 line;
  std::vector<std::size_t> gear_changes;
};
GearedLine corners(const Stretches& stretches);

}  // namespace lsos
