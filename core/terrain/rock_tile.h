// The rocks of a tile of detail, sorted by place, and their height at a point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/height_tile.h"

namespace lsos {

// Rocks of a tile, in the finer grid's coordinates relative to the tile's first node.
class RockTile {
 public:
  struct PlacedRock {
    double U = 0, V = 0;
    // (distance / radius)^2 = a dU^2 + 2 b dU dV + c dV^2
    double a = 0, b = 0, c = 0;
    double height_m = 0;
    double half_U = 0, half_V = 0;  // of the rectangle around it
  };
  void add(const PlacedRock& rock);
  // Sorts the rocks by place; once, after the last one.
  void finish();
  std::size_t bytes() const {
    return rocks_.capacity() * sizeof(PlacedRock) + in_square_.capacity() * sizeof(std::uint32_t);
  }

  // Height of all rocks at a point of the tile, and derivatives by U and V. Zero beside them.
  SurfaceHeight at(const CellPoint& at) const;

 private:
  static constexpr int squares = 8;  // a side
  static constexpr int square_cells = HeightTile::cells / squares;
  std::vector<PlacedRock> rocks_;
  std::array<std::uint32_t, std::size_t{squares} * squares + 1> first_{};
  std::vector<std::uint32_t> in_square_;
};

}  // namespace lsos
