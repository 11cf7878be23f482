// Ground from a raster that GDAL opens.
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <bit>
#include <mutex>

#include "terrain/grid/height_grid.h"
#include "terrain/raster/raster.h"
#include "terrain/raster/raster_advice.h"
#include "terrain/raster/raster_hash.h"
#include "terrain/raster/raster_spikes.h"
#include "terrain/raster/raw_window.h"

namespace lsos {

namespace {

class RasterGrid : public HeightGrid {
 public:
  RasterGrid(const RasterSurface& surface, const Place& place, const SitePlane& plane)
      : plane_(plane), surface_(surface), raster_(surface, place, &plane.site().body()) {
    extent_.u_low = -0.5;
    extent_.u_high = raster_.columns() - 0.5;
    extent_.v_low = -0.5;
    extent_.v_high = raster_.rows() - 0.5;
    extent_.period = map().period_px();
    exact_.period = map().period_px();
    exact_.at = [this](const PlanePoint& at) { return map().coordinates(plane_.place(at)); };
  }

  HeightTile tile(const TileKey& key) const override {
    const std::lock_guard lock(mutex_);
    return raster_tile(key, raster_);
  }
  // A few nodes remain at the coarsest level. Where the raster goes around the body, 2^level
  // divides its columns, so that nodes meet at the seam.
  int coarsest_level() const override {
    const auto sixteenths = static_cast<unsigned>(std::min(raster_.columns(), raster_.rows()) / 16);
    const int level = sixteenths == 0 ? 0 : std::bit_width(sixteenths) - 1;
    if (!raster_.goes_around()) return level;
    return std::min(level, std::countr_zero(static_cast<unsigned>(raster_.columns())));
  }
  Patch patch(const PatchKey& key) const override { return Patch(key, exact_); }
  std::optional<GridPoint> exact(const PlanePoint& at) const override {
    return exact_grid_point(exact_, at);
  }
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const override {
    return map().coordinates(place);
  }
  std::optional<Geodetic> place(const GridCoordinates& at) const override {
    return map().place(at);
  }
  void add_to(Sha256& hash) const override {
    const std::lock_guard lock(mutex_);
    const HeightBand& band = raster_.band();
    hash.add(fmt::format("raster {} {} {}", map().description(), band.scale().scale,
                         band.scale().offset_m));
    if (band.nodata()) hash.add(fmt::format("nodata {}", *band.nodata()));
    add_samples(band.band(), hash);
    for (GDALRasterBand* mask : band.masks()) add_samples(*mask, hash);
    for (const auto& [overview, level] : band.overviews(coarsest_level())) {
      hash.add(fmt::format("overview {}", level));
      add_overview(*overview, hash);
      if (!band.masks().empty()) add_overview(*overview->GetMaskBand(), hash);
    }
  }
  void add_change_to(Sha256& hash) const override {
    const std::lock_guard lock(mutex_);
    const HeightBand& band = raster_.band();
    add_change(band.band(), hash);
    for (const auto& [overview, level] : band.overviews(coarsest_level())) {
      add_change(*overview, hash);
    }
  }
  std::vector<std::string> changed_files() const override { return raster_.files().changed(); }
  std::vector<std::string> advice() const override {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> all{
        overview_advice(raster_.band(), surface_.file),
        unit_advice(raster_, surface_, *this, plane_.site().body()),
        extreme_advice(raster_, surface_, plane_.site().body()),
        quantisation_advice(raster_, surface_, *this, plane_.site().body()),
        picture_advice(raster_, surface_),
        band_advice(raster_, surface_),
        zero_advice(raster_, surface_),
        name_advice(raster_, surface_),
        spike_advice(raster_, surface_, *this, plane_.site().body())};
    std::erase(all, "");
    return all;
  }

 private:
  const RasterMap& map() const { return raster_.map(); }

  const SitePlane& plane_;
  RasterSurface surface_;
  Raster raster_;
  ExactMap exact_;
  mutable std::mutex mutex_;  // a raster serves one thread at a time
};

}  // namespace

std::unique_ptr<HeightGrid> make_raster_grid(const RasterSurface& surface, const Place& place,
                                             const SitePlane& plane) {
  return std::make_unique<RasterGrid>(surface, place, plane);
}

}  // namespace lsos
