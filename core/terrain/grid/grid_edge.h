// The edge of a grid of heights.
#pragma once

#include <vector>

#include "terrain/grid/height_grid.h"

namespace lsos {

// Places all along the edge, so many cells outside of it; inside where that is negative.
std::vector<Geodetic> places_along_edge(const HeightGrid& grid, double outside_cells);

}  // namespace lsos
