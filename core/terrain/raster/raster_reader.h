// A raster read point by point, for instruments: what it holds, and what GDAL's tools compute from
// it. Slow and exact; the ground that wheels roll on is `Ground`.
#pragma once

#include <optional>
#include <string>

#include "terrain/raster/raster.h"

namespace lsos {

struct RasterPoint {
  MapPoint map;  // in the raster's CRS
  // Absent beyond the raster and where a sample that counts is missing.
  std::optional<double> height_m;  // bilinear between cell centres, level beyond the outermost ones
  // Slope and aspect by Horn's formula at the nearest cell, as in gdaldem: on the map, whose
  // distortion is not removed. Aspect is the direction of descent, clockwise from the map's y axis
  // and from true north; absent on level ground.
  std::optional<double> slope_rad;
  std::optional<double> aspect_grid_rad;
  std::optional<double> aspect_rad;
};

class RasterReader {
 public:
  // Opens it on its own body unless one is given. Throws InputError at `place`.
  RasterReader(const RasterSurface& surface, const Place& place, const Body* body = nullptr);

  const Raster& raster() const { return raster_; }
  const Body& own_body() const { return raster_.own_body(); }
  // Unit of the CRS: "m", "deg", ...
  std::string crs_unit() const;
  // nullopt where the projection knows no such place.
  std::optional<RasterPoint> at(const Geodetic& place) const;

 private:
  // Steps to east and north per column and per row, m: of the map, or of the ground where the map
  // is in degrees.
  struct CellSize {
    double east_by_column_m, east_by_row_m, north_by_column_m, north_by_row_m;
  };
  double sample(int column, int row) const;
  std::optional<double> bilinear_m(const GridCoordinates& at) const;
  void add_horn(const GridCoordinates& at, RasterPoint& point) const;
  std::optional<CellSize> cell_size(const GridCoordinates& cell) const;
  std::optional<double> north_azimuth_rad(const GridCoordinates& cell) const;

  const Body* body_;
  Raster raster_;
};

}  // namespace lsos
