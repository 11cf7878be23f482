#include "terrain/raster/raw_window.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/rounding.h"

namespace lsos {

namespace {

// Nodes around a tile: two passes of filling reach two nodes each.
constexpr int halo = 4;
constexpr int side = HeightTile::nodes + 2 * halo;

// Nodes [first, first + side) of a level of the raster, also beyond its edges.
class RawWindow {
 public:
  RawWindow(const TileKey& key, const Raster& raster)
      : first_column_(key.column * HeightTile::cells + HeightTile::first_node - halo),
        first_row_(key.row * HeightTile::cells + HeightTile::first_node - halo),
        level_(key.level),
        columns_(raster.columns() >> level_),
        rows_(raster.rows() >> level_),
        height_m_(std::size_t{side} * side, missing) {}

  double at(int i, int j) const { return height_m_[j * side + i]; }

  // Copies the raster's nodes to where they lie `turns` whole widths farther east.
  void read(const Raster& raster, std::int64_t turns) {
    const std::int64_t east = turns * columns_;
    const auto column_low = std::max<std::int64_t>(first_column_, east);
    const auto column_high = std::min<std::int64_t>(first_column_ + side, east + columns_);
    const auto row_low = std::max<std::int64_t>(first_row_, 0);
    const auto row_high = std::min<std::int64_t>(first_row_ + side, rows_);
    if (column_low >= column_high || row_low >= row_high) return;
    const int width = static_cast<int>(column_high - column_low);
    const int height = static_cast<int>(row_high - row_low);

    const std::vector<double> heights_m = raster.heights_m(
        {static_cast<int>(column_low - east), static_cast<int>(row_low), width, height}, level_);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto i = static_cast<int>(column_low - first_column_) + column;
        const auto j = static_cast<int>(row_low - first_row_) + row;
        height_m_[j * side + i] = heights_m[row * width + column];
      }
    }
  }

  // Reads the raster once for every turn that the window meets.
  void read_around(const Raster& raster) {
    const auto turn_of = [this](std::int64_t column) {
      return (column - (column % columns_ + columns_) % columns_) / columns_;
    };
    const std::int64_t last = turn_of(first_column_ + side - 1);
    for (std::int64_t turns = turn_of(first_column_); turns <= last; ++turns) {
      read(raster, turns);
    }
  }

  // Continues the outermost two columns and rows linearly beyond the raster.
  void continue_columns() {
    for (int j = 0; j < side; ++j) {
      continue_line(first_column_, columns_, j * side, 1);
    }
  }
  void continue_rows() {
    for (int i = 0; i < side; ++i) {
      continue_line(first_row_, rows_, i, side);
    }
  }

  // Fills the holes beside ground, in one pass.
  void fill_holes() {
    std::vector<double> filled = height_m_;
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        if (std::isnan(at(i, j))) filled[j * side + i] = continued(i, j);
      }
    }
    height_m_ = std::move(filled);
  }

 private:
  // Continues the nodes of one line of the window: at `start`, and `stride` apart; `first` is the
  // raster's number of the first of them, `size` the raster's size along the line.
  void continue_line(std::int64_t first, std::int64_t size, int start, int stride) {
    const auto node = [&](std::int64_t number) -> double& {
      return height_m_[start + (number - first) * stride];
    };
    const auto is_inside = [&](std::int64_t number) {
      return number >= first && number < first + side;
    };
    const auto extend = [&](std::int64_t edge, std::int64_t outward) {
      if (!is_inside(edge) || !is_inside(edge - outward)) return;
      const double step_m = node(edge) - node(edge - outward);
      for (std::int64_t k = 1; is_inside(edge + k * outward); ++k) {
        node(edge + k * outward) = node(edge) + static_cast<double>(k) * step_m;
      }
    };
    extend(0, -1);
    extend(size - 1, 1);
  }

  double continued(int i, int j) const {
    double sum_m = 0;
    int count = 0;
    const auto add_continuation = [&](int di, int dj) {
      const int far_i = i + 2 * di;
      const int far_j = j + 2 * dj;
      if (far_i < 0 || far_i >= side || far_j < 0 || far_j >= side) return;
      const double height_m = 2 * at(i + di, j + dj) - at(far_i, far_j);
      if (std::isnan(height_m)) return;
      sum_m += height_m;
      ++count;
    };
    add_continuation(1, 0);
    add_continuation(-1, 0);
    add_continuation(0, 1);
    add_continuation(0, -1);
    return count > 0 ? sum_m / count : missing;
  }

  std::int64_t first_column_;
  std::int64_t first_row_;
  int level_;
  std::int64_t columns_;
  std::int64_t rows_;
  std::vector<double> height_m_;
};

constexpr int to_window = halo - HeightTile::first_node;

void set_nodes(const RawWindow& window, HeightTile& tile) {
  const int last = HeightTile::first_node + HeightTile::nodes;
  for (int row = HeightTile::first_node; row < last; ++row) {
    for (int column = HeightTile::first_node; column < last; ++column) {
      tile.height_m(column, row) = window.at(column + to_window, row + to_window);
    }
  }
}

}  // namespace

HeightTile raw_tile(const TileKey& key, const Raster& raster) {
  RawWindow window(key, raster);
  if (raster.goes_around()) {
    window.read_around(raster);
  } else {
    window.read(raster, 0);
  }
  HeightTile tile(key);
  set_nodes(window, tile);
  return tile;
}

HeightTile raster_tile(const TileKey& key, const Raster& raster) {
  RawWindow window(key, raster);
  if (raster.goes_around()) {
    window.read_around(raster);
  } else {
    window.read(raster, 0);
    window.continue_columns();
  }
  window.continue_rows();

  HeightTile tile(key);
  for (int row = 0; row < HeightTile::cells; ++row) {
    for (int column = 0; column < HeightTile::cells; ++column) {
      const int i = column + to_window;
      const int j = row + to_window;
      const double sum =
          window.at(i, j) + window.at(i + 1, j) + window.at(i, j + 1) + window.at(i + 1, j + 1);
      if (!std::isnan(sum)) tile.set_ground(column, row);
    }
  }
  window.fill_holes();
  window.fill_holes();
  set_nodes(window, tile);
  return tile;
}

}  // namespace lsos
