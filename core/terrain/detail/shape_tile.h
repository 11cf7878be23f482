// Round shapes of a tile of detail, rocks or craters, sorted by place, and their height at a point:
// exact whatever the spacing of the tile's nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/detail/craters.h"
#include "terrain/detail/rocks.h"
#include "terrain/grid/height_tile.h"
#include "terrain/grid/tile_top.h"

namespace lsos {

// Position of a shape, in the finer grid's coordinates relative to the tile's first node.
struct ShapePlace {
  double U = 0, V = 0;
  // (distance / radius)^2 = a dU^2 + 2 b dU dV + c dV^2
  double a = 0, b = 0, c = 0;
  double half_U = 0, half_V = 0;  // half sides of the bounding rectangle
};

// Height of a shape and its derivative by q = (distance / radius)^2.
struct ShapeHeight {
  double height_m;
  double by_q_m;
};

struct PlacedRock {
  static constexpr double reach = 1;  // radii
  ShapePlace place;
  double height_m = 0;
  double top_m() const { return height_m; }
  ShapeHeight at(double q) const {
    const RockShape shape = rock_shape(q);
    return {height_m * shape.height, height_m * shape.by_q};
  }
};

struct PlacedCrater {
  static constexpr double reach = crater_reach;
  ShapePlace place;
  double depth_m = 0, rim_m = 0;
  double top_m() const { return rim_m; }
  ShapeHeight at(double q) const {
    const double r = std::sqrt(q);
    // The bowl is linear in q, so that the derivative is finite also at r = 0.
    const double by_q_m = r < 1e-6 ? crater_slope_m(1e-6, depth_m, rim_m) / 2e-6
                                   : crater_slope_m(r, depth_m, rim_m) / (2 * r);
    return {crater_height_m(r, depth_m, rim_m), by_q_m};
  }
};

template <class Shape>
class ShapeTile {
 public:
  void add(const Shape& shape) { shapes_.push_back(shape); }
  // Sorts the shapes by place. Called once, after the last add().
  void finish();
  std::size_t bytes() const {
    return shapes_.capacity() * sizeof(Shape) + in_square_.capacity() * sizeof(std::uint32_t);
  }

  // Height of all shapes at a point of the tile, and derivatives by U and V. Zero beside them.
  SurfaceHeight at(const CellPoint& at) const;
  // Sum of the greatest heights of the shapes that reach into a square, TileTop::index() numbers
  // it: an upper bound on the height of all in it.
  double top_m(std::size_t square) const {
    double sum_m = 0;
    for (std::uint32_t k = first_[square]; k < first_[square + 1]; ++k) {
      sum_m += std::max(0.0, shapes_[in_square_[k]].top_m());
    }
    return sum_m;
  }

 private:
  static constexpr int cells = HeightTile::cells;
  static constexpr int squares = TileTop::squares;  // per side of the tile
  static constexpr int square_cells = cells / squares;
  std::vector<Shape> shapes_;
  std::array<std::uint32_t, std::size_t{squares} * squares + 1> first_{};
  std::vector<std::uint32_t> in_square_;
};

template <class Shape>
void ShapeTile<Shape>::finish() {
  std::array<std::vector<std::uint32_t>, std::size_t{squares} * squares> lists;
  const auto square = [](double at) {
    return std::clamp(static_cast<int>(std::floor(at / square_cells)), 0, squares - 1);
  };
  for (std::uint32_t k = 0; k < shapes_.size(); ++k) {
    const ShapePlace& p = shapes_[k].place;
    if (p.U + p.half_U < 0 || p.U - p.half_U > cells) continue;
    if (p.V + p.half_V < 0 || p.V - p.half_V > cells) continue;
    for (int j = square(p.V - p.half_V); j <= square(p.V + p.half_V); ++j) {
      for (int i = square(p.U - p.half_U); i <= square(p.U + p.half_U); ++i) {
        lists[static_cast<std::size_t>(j * squares + i)].push_back(k);
      }
    }
  }
  for (std::size_t k = 0; k < lists.size(); ++k) {
    in_square_.insert(in_square_.end(), lists[k].begin(), lists[k].end());
    first_[k + 1] = static_cast<std::uint32_t>(in_square_.size());
  }
}

template <class Shape>
SurfaceHeight ShapeTile<Shape>::at(const CellPoint& at) const {
  SurfaceHeight sum{0, 0, 0};
  if (shapes_.empty()) return sum;
  const int i = static_cast<int>(at.column & (cells - 1));
  const int j = static_cast<int>(at.row & (cells - 1));
  const double U = i + at.along_u, V = j + at.along_v;
  const auto square = static_cast<std::size_t>(j / square_cells * squares + i / square_cells);
  for (std::uint32_t k = first_[square]; k < first_[square + 1]; ++k) {
    const Shape& shape = shapes_[in_square_[k]];
    const ShapePlace& p = shape.place;
    const double away_U = U - p.U, away_V = V - p.V;
    const double by_U = p.a * away_U + p.b * away_V, by_V = p.b * away_U + p.c * away_V;
    const double q = by_U * away_U + by_V * away_V;
    if (q >= Shape::reach * Shape::reach) continue;
    const ShapeHeight height = shape.at(q);
    sum.height_m += height.height_m;
    sum.by_u_m += 2 * height.by_q_m * by_U;
    sum.by_v_m += 2 * height.by_q_m * by_V;
  }
  return sum;
}

}  // namespace lsos
