// What lies below the resolution of a height grid: craters, rocks and roughness on a finer grid
// of its own, `subdivision` nodes a cell. The finer grid's node (U, V) is the grid's point
// u = U / subdivision - 1/2, so that cells' centres are nodes and cells' edges too.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "terrain/craters.h"
#include "terrain/height_grid.h"
#include "terrain/patch_map.h"
#include "terrain/poisson_field.h"
#include "terrain/rock_tile.h"
#include "terrain/roughness.h"
#include "terrain/stereographic.h"

namespace lsos {

struct DetailTile {
  explicit DetailTile(const TileKey& key) : heights(key) {}
  HeightTile heights;
  RockTile rocks;
  const TileKey& key() const { return heights.key(); }
  std::size_t bytes() const { return sizeof(*this) + rocks.bytes(); }
};

// How the detail goes with the grid below it.
struct DetailSetting {
  double cell_m = 1;           // mean side of the grid's cells
  double height_to_width = 1;  // of those
  bool keeps_cells = false;    // zero at cells' centres and in the mean of each cell
  double crater_max_m = 1e9;   // larger ones are the grid's own
};

class DetailField {
 public:
  // `grid` must outlive the field.
  DetailField(const Detail& detail, const HeightGrid& grid, const Stereographic& map,
              const DetailSetting& setting, std::uint64_t seed);

  int subdivision() const { return subdivision_; }
  double spacing_m() const { return setting_.cell_m / subdivision_; }
  // A pure function of the key. Any thread. On a level above 0 every 2^level-th node, without what
  // is too small for those: for looks from afar.
  DetailTile tile(const TileKey& key) const;
  static constexpr int coarsest_level = 20;
  // Of what it holds: a look at what is larger finds nothing.
  double largest_m() const;

 private:
  // The finer grid's coordinates of a point of the grid.
  double fine(double u) const { return (u + 0.5) * subdivision_; }
  std::optional<PlanePoint> map_point(double U, double V) const;
  PlaneRectangle rectangle(const NodeLattice& at) const;
  std::optional<GridPoint> grid_point(const PlanePoint& at) const;
  double near_tile(double U, const NodeLattice& at) const;
  double largest_crater_m() const;
  std::vector<Crater> craters(const NodeLattice& at) const;
  void add_craters(HeightTile& tile, const NodeLattice& at) const;
  void add_rocks(RockTile& tile, const NodeLattice& at) const;
  HeightTile raw(const TileKey& key, const NodeLattice& at) const;
  HeightTile zero_at_centres(const TileKey& key) const;
  double mean_of_cell_m(const TileKey& cell) const;
  void correct_means(HeightTile& tile) const;

  Detail detail_;
  const HeightGrid& grid_;
  Stereographic map_;
  DetailSetting setting_;
  std::uint64_t seed_;
  int subdivision_;
  std::int64_t period_ = 0;  // of the finer grid, nodes; 0: does not go around
  std::optional<RoughnessField> roughness_;
  ExactMap exact_;
  mutable PatchMap patches_;
  mutable KeyCache<TileKey, HeightTile> centres_{megabytes(3)};
  mutable KeyCache<TileKey, double> means_{megabytes(1)};  // of cells of more than a tile, by level
};

}  // namespace lsos
