// The edge of a grid of heights.
#pragma once

#include <vector>

#include "terrain/grid/height_grid.h"

namespace lsos {

// Places all along the edge, that many cells outside it; inside where the number is negative.
std::vector<Geodetic> places_along_edge(const HeightGrid& grid, double outside_cells);

}  // namespace lsos
