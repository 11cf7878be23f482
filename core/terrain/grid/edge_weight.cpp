#include "terrain/grid/edge_weight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "terrain/grid/b_spline.h"

namespace lsos {

namespace {

constexpr int tile_cells = HeightTile::cells;

// The spline reaches two nodes away, and a node belongs to the cells on both sides.
constexpr int margin_cells = 3;

}  // namespace

WeightTile edge_weights(const TileKey& key, int fade_cells, const GridExtent& extent,
                        const std::function<std::shared_ptr<const HeightTile>(TileKey)>& tile) {
  // Marks cells without ground in the window that matters; `fade_cells` is below a tile's width.
  const int halo = fade_cells + margin_cells;
  const auto is_inside = [&](int i, int j) {
    const auto u = static_cast<double>(key.column * tile_cells + i);
    const auto v = static_cast<double>(key.row * tile_cells + j);
    const bool is_between = extent.goes_around() || (u >= extent.u_low && u + 1 <= extent.u_high);
    return is_between && v >= extent.v_low && v + 1 <= extent.v_high;
  };
  const int side = tile_cells + 2 * halo;
  std::vector<char> hole(static_cast<std::size_t>(side) * side, 0);
  bool is_whole = true;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const auto from = tile({key.column + di, key.row + dj, key.level});
      for (int j = std::max(-halo, dj * tile_cells);
           j < std::min(tile_cells + halo, (dj + 1) * tile_cells); ++j) {
        for (int i = std::max(-halo, di * tile_cells);
             i < std::min(tile_cells + halo, (di + 1) * tile_cells); ++i) {
          if (is_inside(i, j) && from->is_ground(i - di * tile_cells, j - dj * tile_cells))
            continue;
          hole[static_cast<std::size_t>((j + halo) * side + i + halo)] = 1;
          is_whole = false;
        }
      }
    }
  }
  WeightTile weights(key);
  weights.is_whole = is_whole;
  // Distance to the nearest hole along each row, then over rows: exact, in cells.
  std::vector<int> along(hole.size());
  for (int j = 0; j < side; ++j) {
    int since = side;
    for (int i = 0; i < side; ++i) {
      since = hole[static_cast<std::size_t>(j * side + i)] ? 0 : since + 1;
      along[static_cast<std::size_t>(j * side + i)] = since;
    }
    since = side;
    for (int i = side - 1; i >= 0; --i) {
      since = hole[static_cast<std::size_t>(j * side + i)] ? 0 : since + 1;
      int& least = along[static_cast<std::size_t>(j * side + i)];
      least = std::min(least, since);
    }
  }
  const int last = HeightTile::first_node + HeightTile::nodes;
  for (int row = HeightTile::first_node; row < last; ++row) {
    for (int column = HeightTile::first_node; column < last; ++column) {
      double least = 1e9;
      for (int j = std::max(0, row + halo - fade_cells - margin_cells);
           j < std::min(side, row + halo + fade_cells + margin_cells); ++j) {
        const double dx =
            along[static_cast<std::size_t>(j * side + std::min(column + halo, side - 1))];
        const double dy = j - row - halo;
        least = std::min(least, dx * dx + dy * dy);
      }
      const double s =
          std::clamp((std::sqrt(least) - margin_cells) / (fade_cells - margin_cells), 0.0, 1.0);
      weights.nodes.height_m(column, row) = s * s * (3 - 2 * s);
    }
  }
  return weights;
}

SurfaceHeight smooth_weight(const WeightTile& weights, const CellPoint& at) {
  if (weights.is_whole) return {1, 0, 0};
  const int i = static_cast<int>(at.column & (tile_cells - 1));
  const int j = static_cast<int>(at.row & (tile_cells - 1));
  const auto u = b_spline(at.along_u), u_slope = b_spline_slope(at.along_u);
  const auto v = b_spline(at.along_v), v_slope = b_spline_slope(at.along_v);
  SurfaceHeight sum{0, 0, 0};
  for (int k = 0; k < 4; ++k) {
    const double* row = weights.nodes.row_m(i - 1, j - 1 + k);
    const double value = u[0] * row[0] + u[1] * row[1] + (u[2] * row[2] + u[3] * row[3]);
    const double slope =
        u_slope[0] * row[0] + u_slope[1] * row[1] + (u_slope[2] * row[2] + u_slope[3] * row[3]);
    sum.height_m += v[k] * value;
    sum.by_u_m += v[k] * slope;
    sum.by_v_m += v_slope[k] * value;
  }
  return sum;
}

}  // namespace lsos
