#include "terrain/grid/tile_top.h"

#include <cmath>

namespace lsos {

namespace {

// The weights of the sixteen nodes around a point sum to 1. In one dimension the negative ones sum
// to -1/8 at most, in the middle of a cell; in two, to -2 (1/8) (9/8). So much of the nodes' range
// the surface may rise above the highest of them.
constexpr double overshoot = 9.0 / 32;

struct Range {
  double least_m, most_m;
  void add(const Range& other) {
    least_m = std::min(least_m, other.least_m);
    most_m = std::max(most_m, other.most_m);
  }
};

// Ranges of the four nodes of a row about each cell. `row` counts as the tile's nodes do.
std::array<Range, HeightTile::cells> along(const HeightTile& tile, int row) {
  std::array<Range, HeightTile::cells> ranges;
  for (int i = 0; i < HeightTile::cells; ++i) {
    const double* at_m = tile.row_m(i - 1, row);
    const auto [least_m, most_m] =
        std::pair{std::min(std::min(at_m[0], at_m[1]), std::min(at_m[2], at_m[3])),
                  std::max(std::max(at_m[0], at_m[1]), std::max(at_m[2], at_m[3]))};
    ranges[static_cast<std::size_t>(i)] = {least_m, most_m};
  }
  return ranges;
}

// Greatest second differences of the sixteen nodes about a cell, along rows and columns.
Vec2 bend_m(const HeightTile& tile, int i, int j) {
  Vec2 bend_m = Vec2::Zero();
  for (int k = -1; k < 3; ++k) {
    for (int n = 0; n < 2; ++n) {
      const double along_row_m = tile.height_m(i + n - 1, j + k) - 2 * tile.height_m(i + n, j + k) +
                                 tile.height_m(i + n + 1, j + k);
      const double along_column_m = tile.height_m(i + k, j + n - 1) -
                                    2 * tile.height_m(i + k, j + n) +
                                    tile.height_m(i + k, j + n + 1);
      bend_m = bend_m.cwiseMax(Vec2(std::abs(along_row_m), std::abs(along_column_m)));
    }
  }
  return bend_m;
}

}  // namespace

TileTop tile_top(const HeightTile& tile) {
  TileTop top{tile.key(), {}, {}, {}};
  top.bend_m.fill(Vec2::Zero());
  top.highest_m.fill(-std::numeric_limits<double>::infinity());
  top.is_whole.set();
  std::array<std::array<Range, HeightTile::cells>, 4> rows;  // by row of nodes, modulo 4
  for (int row = -1; row < 2; ++row) rows[static_cast<std::size_t>(row & 3)] = along(tile, row);
  for (int j = 0; j < HeightTile::cells; ++j) {
    rows[static_cast<std::size_t>((j + 2) & 3)] = along(tile, j + 2);
    for (int i = 0; i < HeightTile::cells; ++i) {
      const std::size_t square =
          TileTop::index(i >> TileTop::square_bits, j >> TileTop::square_bits);
      if (!tile.is_ground(i, j)) {
        top.is_whole.reset(square);
        continue;
      }
      const auto cell = static_cast<std::size_t>(i);
      Range nodes = rows[0][cell];
      for (std::size_t k = 1; k < rows.size(); ++k) nodes.add(rows[k][cell]);
      const double most_m = nodes.most_m + overshoot * (nodes.most_m - nodes.least_m);
      top.highest_m[square] = std::max(top.highest_m[square], most_m);
      top.bend_m[square] = top.bend_m[square].cwiseMax(bend_m(tile, i, j));
    }
  }
  return top;
}

}  // namespace lsos
