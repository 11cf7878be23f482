// Upper bounds on the surface through a tile's nodes, by squares of cells: what is known to lie low
// need not be sampled.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <limits>

#include "base/vector.h"
#include "terrain/grid/height_tile.h"

namespace lsos {

struct TileTop {
  static constexpr int square_bits = 3;  // a square has 8 x 8 cells
  static constexpr int squares_bits = CellPoint::tile_bits - square_bits;
  static constexpr int squares = 1 << squares_bits;  // on each side of the tile

  TileKey of;
  std::array<double, std::size_t{squares} * squares> highest_m;  // -infinity without any ground
  // Greatest second difference of nodes along rows and along columns.
  std::array<Vec2, std::size_t{squares} * squares> bend_m;
  std::bitset<std::size_t{squares} * squares> is_whole;  // all cells are ground

  const TileKey& key() const { return of; }
  static std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row) * squares + static_cast<std::size_t>(column);
  }
};

TileTop tile_top(const HeightTile& tile);

// Squares of all tiles of a level: [column_low, column_high] x [row_low, row_high].
struct SquareRange {
  std::int64_t column_low = 0, column_high = 0, row_low = 0, row_high = 0;

  // The squares that hold the points between two corners, in cells of the level.
  static SquareRange between(const CellPoint& low, const CellPoint& high) {
    constexpr int bits = TileTop::square_bits;
    return {low.column >> bits, high.column >> bits, low.row >> bits, high.row >> bits};
  }
  std::int64_t size() const { return (column_high - column_low + 1) * (row_high - row_low + 1); }
};

// Upper bound on the ground in some squares.
struct HighestGround {
  double highest_m = -std::numeric_limits<double>::infinity();
  Vec2 bend_m = Vec2::Zero();  // as TileTop has it
  bool is_whole = true;        // there is ground everywhere
};

// Height by which the surface may exceed the highest of its values at the corners of a rectangle of
// u x v cells. Interpolation that is linear along both sides errs by at most an eighth of the
// square of each side times the second derivative along it. That of a Catmull-Rom cubic is at most
// three second differences of its nodes, and the weights across it add up to at most 5/4.
inline double greatest_bulge_m(const Vec2& bend_m, double u, double v) {
  constexpr double derivative = 3 * 5.0 / 4;
  return derivative / 8 * (u * u * bend_m.x() + v * v * bend_m.y());
}

// `top(key)` returns the TileTop of a tile of that level.
template <class TopOf>
HighestGround highest_ground(const SquareRange& range, int level, const TopOf& top) {
  HighestGround highest;
  for (std::int64_t row = range.row_low; row <= range.row_high; ++row) {
    for (std::int64_t column = range.column_low; column <= range.column_high; ++column) {
      constexpr int bits = TileTop::squares_bits, last = TileTop::squares - 1;
      const TileTop& tile = top(TileKey{column >> bits, row >> bits, level});
      const std::size_t square =
          TileTop::index(static_cast<int>(column & last), static_cast<int>(row & last));
      highest.highest_m = std::max(highest.highest_m, tile.highest_m[square]);
      highest.bend_m = highest.bend_m.cwiseMax(tile.bend_m[square]);
      highest.is_whole &= tile.is_whole[square];
    }
  }
  return highest;
}

}  // namespace lsos
