// Heights of a map's cells, linear between their centres, as GIS programs model the ground.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "terrain/raster/map_grid.h"

namespace lsos {

class MapHeights {
 public:
  MapHeights(const MapGrid& grid, const Body& body);

  // Heights of the cells of a row; NaN where there is no ground.
  std::span<float> row(int row) {
    return {&heights_m_[static_cast<std::size_t>(row) * columns_], columns_};
  }
  int columns() const { return static_cast<int>(columns_); }
  int rows() const { return static_cast<int>(rows_); }
  const RasterMap& map() const { return map_; }

  // Coordinates within rounding of a cell's centre are snapped to it: otherwise a cell beside cells
  // without ground could lose its height.
  std::optional<GridCoordinates> coordinates(const Geodetic& place) const;

  // Whether the coordinates lie on the map, or within half a cell of its edge.
  bool holds(const std::optional<GridCoordinates>& at) const;
  // Absent beyond the centres of the outermost cells, and where one of the four cells around the
  // place has no ground.
  std::optional<double> height_m(const GridCoordinates& at) const;
  std::optional<double> height_m(const Geodetic& place) const;

 private:
  double in_period(double u) const;

  RasterMap map_;
  std::size_t columns_, rows_;
  bool is_periodic_;
  std::vector<float> heights_m_;
};

}  // namespace lsos
