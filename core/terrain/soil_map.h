// Soil at each place of the ground.
#pragma once

#include <memory>
#include <vector>

#include "terrain/detail/poisson_field.h"
#include "terrain/grid/height_grid.h"
#include "terrain/grid/key_cache.h"
#include "terrain/grid/patch_map.h"
#include "terrain/grid/site_plane.h"

namespace lsos {

class SoilMap {
 public:
  // Throws InputError where a raster of soils cannot be used or a patch's corner lies more than 60
  // degrees from the site. `plane` must outlive the map.
  SoilMap(const TerrainSpec& spec, const SitePlane& plane);
  ~SoilMap();

  // Soils: the terrain's own, those of its patches in order, and that of rocks.
  const std::vector<Soil>& soils() const { return soils_; }
  int rock_index() const { return static_cast<int>(soils_.size()) - 1; }
  // Index of the soil at a point of the site plane. May be called from any thread.
  int at(const PlanePoint& at) const;
  void add_to(Sha256& hash) const;
  // See HeightGrid.
  std::vector<std::string> changed_files() const;

 private:
  struct Region;
  std::vector<Soil> soils_;
  std::vector<std::unique_ptr<Region>> regions_;
};

}  // namespace lsos
