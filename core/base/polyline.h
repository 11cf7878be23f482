// Lines of straight pieces in the plane.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vector.h"

namespace lsos {

// The line without points that it hardly bends at (Douglas and Peucker 1973): none of its points is
// farther than `tolerance_m` from the simplified line, which keeps both ends.
std::vector<Vec2> simplified(const std::vector<Vec2>& line_m, double tolerance_m);
// Which points of the line those are; ascending.
std::vector<std::size_t> points_of_simplified(const std::vector<Vec2>& line_m, double tolerance_m);

}  // namespace lsos
