// Uniform cubic B-splines on a lattice of every 2^k-th node of a grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "terrain/grid/height_tile.h"

namespace lsos {

// Weights of the lattice points at -1, 0, 1, 2 for a point at t in [0, 1).
inline std::array<double, 4> b_spline(double t) {
  const double s = 1 - t, t2 = t * t, t3 = t2 * t;
  return {s * s * s / 6, (4 - 6 * t2 + 3 * t3) / 6, (1 + 3 * t + 3 * t2 - 3 * t3) / 6, t3 / 6};
}

// Derivatives of those weights by t.
inline std::array<double, 4> b_spline_slope(double t) {
  const double s = 1 - t, t2 = t * t;
  return {-s * s / 2, (3 * t2 - 4 * t) / 2, (1 + 2 * t - 3 * t2) / 2, t2 / 2};
}

// Position of a tile's nodes on a lattice along one axis: the lattice points in use, and for each
// node the first of its four points among them and their weights.
struct SplineAxis {
  SplineAxis(std::int64_t first, std::int64_t stride, int spacing_log2) {
    const std::int64_t mask = (std::int64_t{1} << spacing_log2) - 1;
    const double per_spacing = 1.0 / static_cast<double>(mask + 1);
    for (int k = 0; k < HeightTile::nodes; ++k) {
      const std::int64_t node = first + k * stride;
      const std::int64_t low = (node >> spacing_log2) - 1;
      if (points.empty()) points.push_back(low);
      while (points.back() < low + 3) points.push_back(points.back() + 1);
      start[k] = static_cast<int>(low - points.front());
      weights[k] = b_spline(static_cast<double>(node & mask) * per_spacing);
    }
  }
  std::vector<std::int64_t> points;  // consecutive
  std::array<int, HeightTile::nodes> start{};
  std::array<std::array<double, 4>, HeightTile::nodes> weights{};
};

}  // namespace lsos
