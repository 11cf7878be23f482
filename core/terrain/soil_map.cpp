#include "terrain/soil_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrain/raster/raster.h"
#include "terrain/raster/raw_window.h"

namespace lsos {

namespace {

// Soil of rocks where the script names none: it bears any wheel and grips by friction alone.
Soil bare_rock() {
  Soil soil;
  soil.name = "rock";
  soil.is_rigid = true;
  soil.cohesion_pa = 0;
  soil.friction_rad = std::atan(0.7);  // of a metal or rubber wheel, an assumption
  soil.density_kgpm3 = 2900;
  soil.shear_modulus_x_m = soil.shear_modulus_y_m = 0.002;
  return soil;
}

}  // namespace

// One patch: a polygon on the site plane, whose edges are great circles there, or a raster.
struct SoilMap::Region {
  std::vector<PlanePoint> corners;
  PlaneRectangle box;
  std::unique_ptr<HeightGrid> raster;
  std::unique_ptr<PatchMap> patches;
  std::vector<double> values;
  std::unique_ptr<Raster> samples;  // of the same raster; read under the lock of `tiles`
  mutable KeyCache<TileKey, HeightTile> tiles{megabytes(10)};

  bool holds(const PlanePoint& at) const {
    return raster != nullptr ? raster_holds(at) : polygon_holds(at);
  }

 private:
  bool polygon_holds(const PlanePoint& at) const {
    if (at.x_m < box.low.x_m || at.x_m > box.high.x_m) return false;
    if (at.y_m < box.low.y_m || at.y_m > box.high.y_m) return false;
    // Crossings of a ray to the east decide whether the point is inside.
    bool is_inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
      const PlanePoint &a = corners[i], &b = corners[j];
      if ((a.y_m > at.y_m) == (b.y_m > at.y_m)) continue;
      const double x_m = a.x_m + (at.y_m - a.y_m) / (b.y_m - a.y_m) * (b.x_m - a.x_m);
      if (at.x_m < x_m) is_inside = !is_inside;
    }
    return is_inside;
  }
  bool raster_holds(const PlanePoint& at) const {
    const auto patch = patches->patch(at);
    const auto point = patch->is_good() ? std::optional(patch->at(at)) : raster->exact(at);
    if (!point) return false;
    double u = point->u;
    if (!raster->extent().bring_inside(u, point->v)) return false;
    // The cell that holds the point is the node nearest to it.
    const CellPoint cell(u + 0.5, point->v + 0.5);
    const auto tile =
        tiles.get(cell.tile(), [this](const TileKey& key) { return raw_tile(key, *samples); });
    const double value = tile->height_m(static_cast<int>(cell.column & (HeightTile::cells - 1)),
                                        static_cast<int>(cell.row & (HeightTile::cells - 1)));
    return std::ranges::find(values, value) != values.end();
  }
};

SoilMap::SoilMap(const TerrainSpec& spec, const SitePlane& plane) : soils_{spec.soil} {
  for (const SoilPatch& patch : spec.soil_patches) {
    soils_.push_back(patch.soil);
    auto region = std::make_unique<Region>();
    region->values = patch.values;
    if (patch.raster) {
      RasterSurface classes = *patch.raster;
      classes.has_classes = true;
      region->raster = make_raster_grid(classes, spec.place, plane);
      region->samples = std::make_unique<Raster>(classes, spec.place, &plane.site().body());
      const HeightGrid* raster = region->raster.get();
      region->patches =
          std::make_unique<PatchMap>([raster](const PatchKey& key) { return raster->patch(key); });
    }
    for (const auto& [lon_deg, lat_deg] : patch.lon_lat_deg) {
      const ProjectedPoint projected =
          plane.projected(plane.site().p_S_m(geodetic_from_degrees(lon_deg, lat_deg)));
      if (!projected.is_near) {
        throw InputError(spec.place,
                         fmt::format("the corner {},{} of a soil patch lies more than 60 degrees "
                                     "from the site; a smaller patch is wanted",
                                     lon_deg, lat_deg));
      }
      const PlanePoint& at = projected.at;
      if (region->corners.empty()) region->box = {at, at};
      region->corners.push_back(at);
      PlaneRectangle& box = region->box;
      box.low = {std::min(box.low.x_m, at.x_m), std::min(box.low.y_m, at.y_m)};
      box.high = {std::max(box.high.x_m, at.x_m), std::max(box.high.y_m, at.y_m)};
    }
    regions_.push_back(std::move(region));
  }
  soils_.push_back(spec.rock_soil.value_or(bare_rock()));
}

SoilMap::~SoilMap() = default;

int SoilMap::at(const PlanePoint& at) const {
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    if (regions_[k]->holds(at)) return static_cast<int>(k) + 1;
  }
  return 0;
}

void SoilMap::add_to(Sha256& hash) const {
  for (const Soil& s : soils_) {
    hash.add(fmt::format("\nsoil {} {} {} {} {} {} {} {} {} {} {}", s.name, s.is_rigid, s.k_c,
                         s.k_phi, s.n, s.cohesion_pa, s.friction_rad, s.density_kgpm3,
                         s.shear_modulus_x_m, s.shear_modulus_y_m, s.slip_sinkage));
  }
  for (const auto& region : regions_) {
    for (const PlanePoint& p : region->corners) hash.add(fmt::format("\n{} {}", p.x_m, p.y_m));
    if (region->raster != nullptr) region->raster->add_to(hash);
    for (const double value : region->values) hash.add(fmt::format("\n{}", value));
  }
}

std::vector<std::string> SoilMap::changed_files() const {
  std::vector<std::string> all;
  for (const auto& region : regions_) {
    if (region->raster == nullptr) continue;
    const std::vector<std::string> changed = region->raster->changed_files();
    all.insert(all.end(), changed.begin(), changed.end());
  }
  return all;
}

}  // namespace lsos
