// A square piece of a height grid, and the smooth surface through its nodes.
#pragma once

#include <array>
#include <bitset>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace lsos {

// Key of a tile: cells [64 column, 64 column + 64) x [64 row, 64 row + 64). On a level above 0 a
// cell is 2^level cells of the grid a side: a coarser level of detail.
struct TileKey {
  std::int64_t column = 0;
  std::int64_t row = 0;
  int level = 0;

  auto operator<=>(const TileKey&) const = default;
};

// Heights at nodes (column, row) of the grid; cell (i, j) lies between nodes i, i + 1 and j, j + 1.
// One node more before and two more after the cells serve the cubics.
class HeightTile {
 public:
  static constexpr int cells = 64;
  static constexpr int first_node = -1;
  static constexpr int nodes = cells + 3;

  explicit HeightTile(TileKey key) : key_(key) {}

  const TileKey& key() const { return key_; }

  // Node and cell numbers count from the tile's own first cell.
  double& height_m(int column, int row) { return height_m_[index(column, row)]; }
  // Pointer to four nodes of a row, from this one on.
  const double* row_m(int column, int row) const { return &height_m_[index(column, row)]; }
  double height_m(int column, int row) const { return height_m_[index(column, row)]; }
  void set_ground(int column, int row) { ground_.set(cell(column, row)); }
  void set_ground_everywhere() { ground_.set(); }
  bool is_ground(int column, int row) const { return ground_[cell(column, row)]; }

 private:
  static std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row - first_node) * nodes +
           static_cast<std::size_t>(column - first_node);
  }

  static std::size_t cell(int column, int row) {
    return static_cast<std::size_t>(row) * cells + static_cast<std::size_t>(column);
  }

  TileKey key_;
  std::array<double, std::size_t{nodes} * nodes> height_m_{};
  std::bitset<std::size_t{cells} * cells> ground_;
};

// Height of the surface and its derivatives by column and row; NaN where there is no ground.
struct SurfaceHeight {
  double height_m = 0;
  double by_u_m = 0;
  double by_v_m = 0;
};

// A point of the grid: its cell and the position within it, each in [0, 1).
struct CellPoint {
  CellPoint(double u, double v) : column(floor_of(u)), row(floor_of(v)) {
    along_u = u - static_cast<double>(column);
    along_v = v - static_cast<double>(row);
  }

  TileKey tile() const { return {column >> tile_bits, row >> tile_bits}; }

  std::int64_t column;
  std::int64_t row;
  double along_u;
  double along_v;

  static constexpr int tile_bits = 6;
  static_assert(HeightTile::cells == 1 << tile_bits);

 private:
  // std::floor is a call on processors without SSE 4.1.
  static std::int64_t floor_of(double value) {
    const auto truncated = static_cast<std::int64_t>(value);
    return truncated - (static_cast<double>(truncated) > value);
  }
};

// Bicubic Catmull-Rom interpolation (Catmull and Rom 1974; Keys 1981 with a = -1/2): equal to the
// grid at its nodes, C1, exact for linear and quadratic surfaces. The point must lie in the tile.
SurfaceHeight surface_height(const HeightTile& tile, const CellPoint& at);

}  // namespace lsos
