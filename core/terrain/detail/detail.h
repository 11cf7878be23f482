// Detail below the resolution of a height grid: craters, rocks and roughness on a finer grid of its
// own, `subdivision` nodes per cell. The finer grid's node (U, V) is the grid's point
// u = U / subdivision - 1/2, so that cells' centres are nodes and cells' edges too.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "terrain/detail/craters.h"
#include "terrain/detail/poisson_field.h"
#include "terrain/detail/roughness.h"
#include "terrain/detail/shape_tile.h"
#include "terrain/detail/volume_lattice.h"
#include "terrain/grid/height_grid.h"
#include "terrain/grid/patch_map.h"
#include "terrain/grid/stereographic.h"

namespace lsos {

struct DetailTile {
  explicit DetailTile(const TileKey& key) : heights(key) {}
  HeightTile heights;
  ShapeTile<PlacedCrater> craters;  // those too small for the heights' nodes
  ShapeTile<PlacedRock> rocks;
  const TileKey& key() const { return heights.key(); }
  std::size_t bytes() const { return sizeof(*this) + craters.bytes() + rocks.bytes(); }
};

// Upper bounds on the detail of a tile.
TileTop tile_top(const DetailTile& tile);

// Relation of the detail to the grid below it.
struct DetailSetting {
  double cell_m = 1;            // mean side of the grid's cells
  double height_to_width = 1;   // aspect of those cells
  bool is_over_raster = false;  // nothing is added at the scale of cells, which a raster knows
  double crater_max_m = 1e9;    // larger ones belong to the grid itself
};

class DetailField {
 public:
  // `grid` must outlive the field.
  DetailField(const Detail& detail, const HeightGrid& grid, const Stereographic& map,
              const DetailSetting& setting, std::uint64_t seed);

  int subdivision() const { return subdivision_; }
  double spacing_m() const { return setting_.cell_m / subdivision_; }
  // Tile of detail, a pure function of the key; may be called from any thread. A level above 0 has
  // every 2^level-th node, without what is too small for those.
  DetailTile tile(const TileKey& key) const;
  static constexpr int coarsest_level = 20;
  // Greatest diameter of craters and rocks over a raster, m. Wider ones could not be kept out of
  // the mean over two cells without losing their shape: of craters of 1.25 cells a tenth of their
  // relief would stay there.
  static double largest_over_raster(double cell_m) { return cell_m; }
  // Size of the largest feature, m: with a coarser resolution there is nothing to find.
  double largest_m() const;

 private:
  // Converts a coordinate of the grid to the finer grid.
  double to_fine_grid(double u) const { return (u + 0.5) * subdivision_; }
  std::optional<PlanePoint> map_point(double U, double V) const;
  PlaneRectangle map_rectangle(const NodeRectangle& on_grid) const;
  std::optional<GridPoint> grid_point(const PlanePoint& at) const;
  double near_tile(double U, const NodeLattice& at) const;
  double smallest_crater_m(int level) const;
  double smallest_rock_m(int level) const;
  ShapePlace shape_place(const GridPoint& centre, double radius_m, double reach,
                         const NodeLattice& at) const;
  void add_craters(DetailTile& tile, const NodeLattice& at) const;
  void add_to_nodes(HeightTile& tile, const Crater& crater, const GridPoint& centre,
                    const NodeLattice& at) const;
  void add_rocks(DetailTile& tile, const NodeLattice& at) const;
  void set_lattice();
  void subtract_volumes(HeightTile& tile, const NodeLattice& at) const;
  void add_volume(VolumeLattice& lattice, const NodeLattice& at, const PlanePoint& centre,
                  double volume_m3) const;

  Detail detail_;
  const HeightGrid& grid_;
  Stereographic map_;
  DetailSetting setting_;
  std::uint64_t seed_;
  int subdivision_;
  std::int64_t period_ = 0;  // nodes of the finer grid around the body; 0: does not go around
  std::optional<RoughnessField> roughness_;
  int lattice_column_log2_ = 0, lattice_row_log2_ = 0;
  double largest_crater_m_ = 0, largest_rock_m_ = 0;
  std::vector<double> mean_of_small_m_;  // mean height of what is not counted one by one, by level
  ExactMap exact_;
  mutable PatchMap patches_;
};

}  // namespace lsos
