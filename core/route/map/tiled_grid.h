// Sparse storage for values of the nodes of a large lattice, of which a search visits only a few.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace lsos {

// Every node holds T's default value until it is set. Memory is allocated at first access, in tiles
// of 16 x 16 nodes.
template <class T>
class TiledGrid {
 public:
  TiledGrid(int columns, int rows)
      : tile_columns_(tiles(columns)), tiles_(tile_columns_ * tiles(rows)) {}

  // 0 <= column < columns, the same for rows.
  T& operator()(int column, int row) {
    auto& tile = tiles_[static_cast<std::size_t>(row >> bits) * tile_columns_ +
                        static_cast<std::size_t>(column >> bits)];
    if (!tile) tile = std::make_unique<Tile>();
    return (*tile)[static_cast<std::size_t>((row & mask) << bits | (column & mask))];
  }

 private:
  static constexpr int bits = 4, mask = (1 << bits) - 1;
  static constexpr std::size_t tiles(int nodes) {
    return static_cast<std::size_t>(((nodes - 1) >> bits) + 1);
  }
  using Tile = std::array<T, std::size_t{1} << (2 * bits)>;

  std::size_t tile_columns_;
  std::vector<std::unique_ptr<Tile>> tiles_;
};

}  // namespace lsos
