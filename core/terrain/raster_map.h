// Where places of the body lie on a raster: its CRS and geotransform.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/error.h"
#include "planet/body.h"
#include "terrain/patch.h"

class GDALDataset;

namespace lsos {

class RasterMap {
 public:
  // Throws InputError at `place`, naming `file`: no CRS, no geotransform, or another body's.
  RasterMap(GDALDataset& dataset, const Body& body, const Place& place, const std::string& file);
  ~RasterMap();

  // Column and row, whole numbers at cell centres, perhaps outside the raster; nullopt where the
  // projection knows no such place. May be called from any thread.
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const;

  // Columns once around the body where the projection repeats itself along rows; else 0.
  double period_px() const { return period_px_; }

  // All of it that decides where heights lie.
  std::string description() const;

 private:
  struct Projection;
  void find_period(int columns);

  std::array<double, 6> geotransform_{};
  std::array<double, 6> inverse_{};
  std::unique_ptr<Projection> projection_;
  mutable std::mutex mutex_;  // PROJ's transformations are not thread-safe
  int columns_;
  double period_px_ = 0;
};

}  // namespace lsos
