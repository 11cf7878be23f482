// Ground from a raster that GDAL opens.
#include <fmt/format.h>
#include <gdal_priv.h>

#include <cmath>
#include <mutex>

#include "base/units.h"
#include "terrain/gdal_call.h"
#include "terrain/height_grid.h"
#include "terrain/raster_advice.h"
#include "terrain/raster_hash.h"
#include "terrain/raster_map.h"
#include "terrain/raw_window.h"

namespace lsos {

namespace {

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALAllRegister();
    bound_block_cache();
  });
}

std::unique_ptr<GDALDataset> opened(const RasterSurface& surface, const Place& place) {
  register_drivers();
  const GdalSilence silence;
  std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
      surface.file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  const auto refuse = [&](const std::string& why) {
    throw InputError(place, fmt::format("raster '{}' {}", surface.file, why));
  };
  if (dataset == nullptr) refuse(fmt::format("cannot be opened: {}", GdalSilence::message()));
  const int bands = dataset->GetRasterCount();
  if (surface.band < 1 || surface.band > bands) {
    refuse(fmt::format("has no band {}: 1..{} is allowed", surface.band, bands));
  }
  if (dataset->GetRasterXSize() < 2 || dataset->GetRasterYSize() < 2) {
    refuse(fmt::format("has {} x {} cells; at least 2 x 2 are needed", dataset->GetRasterXSize(),
                       dataset->GetRasterYSize()));
  }
  if (GDALDataTypeIsComplex(dataset->GetRasterBand(surface.band)->GetRasterDataType())) {
    refuse("holds complex numbers; heights are real");
  }
  return dataset;
}

// height = raw * scale + offset. The band's unit is taken where it names a length that we know.
// Radii instead of heights, as PDS has them, show in an offset of the body's size.
HeightScale height_scale(GDALRasterBand& band, const Body& body) {
  HeightScale result{band.GetScale(), band.GetOffset()};
  const Unit* unit = find_unit(band.GetUnitType());
  if (unit != nullptr && unit->kind == "length") {
    result.scale *= unit->si_factor;
    result.offset_m *= unit->si_factor;
  }
  const double radius_m = body.equatorial_radius_m;
  if (std::abs(result.offset_m / radius_m - 1) < 0.005) result.offset_m -= radius_m;
  return result;
}

class RasterGrid : public HeightGrid {
 public:
  RasterGrid(const RasterSurface& surface, const Place& place, const SitePlane& plane)
      : plane_(plane),
        dataset_(opened(surface, place)),
        band_(*dataset_->GetRasterBand(surface.band)),
        map_(*dataset_, plane.site().body(), place, surface.file),
        scale_(height_scale(band_, plane.site().body())) {
    const int columns = dataset_->GetRasterXSize();
    extent_.u_low = -0.5;
    extent_.u_high = columns - 0.5;
    extent_.v_low = -0.5;
    extent_.v_high = dataset_->GetRasterYSize() - 0.5;
    extent_.period = map_.period_px();
    exact_.period = map_.period_px();
    exact_.at = [this](const PlanePoint& at) { return map_.coordinates(plane_.place(at)); };
    goes_around_ = extent_.period == columns;
  }

  HeightTile tile(const TileKey& key) const override {
    const std::lock_guard lock(mutex_);
    return raster_tile(key, band_, scale_, goes_around_);
  }
  Patch patch(const PatchKey& key) const override { return Patch(key, exact_); }
  std::optional<GridPoint> exact(const PlanePoint& at) const override {
    return exact_grid_point(exact_, at);
  }
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const override {
    return map_.coordinates(place);
  }
  void add_to(Sha256& hash) const override {
    const std::lock_guard lock(mutex_);
    hash.add(fmt::format("raster {} {} {}", map_.description(), scale_.scale, scale_.offset_m));
    add_samples(band_, hash);
  }
  std::string advice() const override {
    const std::lock_guard lock(mutex_);
    return raster_advice(band_, dataset_->GetDescription());
  }

 private:
  const SitePlane& plane_;
  std::unique_ptr<GDALDataset> dataset_;
  GDALRasterBand& band_;
  RasterMap map_;
  HeightScale scale_;
  ExactMap exact_;
  bool goes_around_ = false;
  mutable std::mutex mutex_;  // a GDAL dataset serves one thread at a time
};

}  // namespace

std::unique_ptr<HeightGrid> make_raster_grid(const RasterSurface& surface, const Place& place,
                                             const SitePlane& plane) {
  return std::make_unique<RasterGrid>(surface, place, plane);
}

}  // namespace lsos
