// Map between places of the body and cells of a raster: its CRS and geotransform.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "planet/body.h"
#include "terrain/grid/patch.h"
#include "terrain/raster/raster_name.h"

class OGRSpatialReference;

namespace lsos {

// Point in the axes and units of a CRS; x is east or longitude.
struct MapPoint {
  double x = 0;
  double y = 0;
};

class RasterMap {
 public:
  // Refuses a CRS that PROJ cannot use.
  RasterMap(const OGRSpatialReference& crs, const std::array<double, 6>& geotransform, int columns,
            const Body& body, const RasterName& name);
  ~RasterMap();

  // Column and row, whole numbers at cell centres, perhaps outside the raster; nullopt where the
  // projection knows no such place. May be called from any thread.
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const;
  // Inverse of coordinates(), with height 0; nullopt beyond a pole and where the projection ends.
  std::optional<Geodetic> place(const GridCoordinates& at) const;

  // The point in coordinates of the CRS.
  MapPoint map_point(const GridCoordinates& at) const;
  const OGRSpatialReference& crs() const;
  const std::array<double, 6>& geotransform() const { return geotransform_; }

  // Columns once around the body where the projection repeats itself along rows; else 0.
  double period_px() const { return period_px_; }

  // Text of all that decides where heights lie.
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
