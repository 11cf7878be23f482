// Pieces of a grid of nodes.
#pragma once

#include <cstdint>

namespace lsos {

// Every `stride`-th node of the grid from (column, row) on. What is smaller than 2^level nodes is
// left out.
struct NodeLattice {
  std::int64_t column = 0;
  std::int64_t row = 0;
  std::int64_t stride = 1;
  int level = 0;
};

// Rectangle of columns U and rows V of the grid, also between nodes.
struct NodeRectangle {
  double U_low = 0;
  double V_low = 0;
  double U_high = 0;
  double V_high = 0;
};

}  // namespace lsos
