// Size of a grid's cells on the ground.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "terrain/grid/height_grid.h"

namespace lsos {

struct CellSides {
  double along_row_m = std::numeric_limits<double>::infinity();
  double along_column_m = std::numeric_limits<double>::infinity();
  double mean_m() const { return std::sqrt(along_row_m * along_column_m); }
};

// Sides of the cell about a point; infinite where the grid is not mapped. Beyond a pole there is no
// next row; the one before is as high.
inline CellSides cell_sides(const HeightGrid& grid, const Body& body, const GridCoordinates& at) {
  const auto here = grid.place(at), right = grid.place({at.u + 1, at.v});
  auto below = grid.place({at.u, at.v + 1});
  if (!below) below = grid.place({at.u, at.v - 1});
  if (!here || !right || !below) return {};
  return {surface_distance_m(body, *here, *right), surface_distance_m(body, *here, *below)};
}

inline GridCoordinates centre(const GridExtent& extent) {
  if (!std::isfinite(extent.u_low)) return {0, 0};
  return {(extent.u_low + extent.u_high) / 2, (extent.v_low + extent.v_high) / 2};
}

}  // namespace lsos
