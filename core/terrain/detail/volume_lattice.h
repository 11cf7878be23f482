// Volumes of small shapes at the scale of a raster, to be subtracted from them: each shape's
// volume, spread around its place as widely as a cell of the raster.
//
// A shape of height h(x) and volume V becomes h(x) - V K(x - x0), where K is two cubic B-splines on
// a lattice, one after the other: bell-shaped, nearly round, with a standard deviation of sqrt(2/3)
// lattice spacings per axis and an integral of 1. On a lattice of half a cell that is 0.41 cells: a
// narrower bell would take the shape itself away, a wider one would leave some of it at the
// raster's scale.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "terrain/grid/b_spline.h"
#include "terrain/grid/node_lattice.h"

namespace lsos {

// Position on one axis of the lattice: the four points around it, by number, and their weights.
struct LatticePlace {
  LatticePlace(double at, int spacing_log2);
  std::int64_t first = 0;
  std::array<double, 4> weights{};
};

class VolumeLattice {
 public:
  // Lattice for the nodes of a tile: every 2^log2-th column and row of nodes.
  VolumeLattice(const NodeLattice& at, int column_log2, int row_log2);

  // Volumes beyond this rectangle do not count.
  const NodeRectangle& reach() const { return reach_; }
  // The finest lattice spacing, nodes.
  int spacing() const;

  // Adds a volume at a point of the nodes' grid, in m times the area between four nodes.
  void add(double U, double V, double volume_m);
  // The same for many rows of points, whose columns are located once.
  using Columns = std::vector<LatticePlace>;
  Columns columns(double U, double step, std::size_t count) const;
  void add_row(const Columns& at, double V, std::span<const double> volumes_m);

  // Subtracts the sum of all volumes from the tile's heights.
  void subtract_from(HeightTile& tile) const;

 private:
  void add_to_columns(const LatticePlace& at, double volume_m);
  void add_columns_at(double V);

  int column_log2_, row_log2_;
  SplineAxis columns_, rows_;
  NodeRectangle reach_;
  std::vector<double> heights_m_;  // at the lattice's points, row by row
  std::vector<double> line_m_;     // at its columns and beside, while a row is added
};

}  // namespace lsos
