// Regular grids of cells on a map, to be written as rasters.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "planet/body.h"
#include "terrain/raster/raster.h"

namespace lsos {

// Window in degrees; it crosses the 180th meridian where east_deg < west_deg.
struct MapWindow {
  double west_deg = 0;
  double south_deg = 0;
  double east_deg = 0;
  double north_deg = 0;

  double width_deg() const {
    return east_deg < west_deg ? east_deg - west_deg + 360 : east_deg - west_deg;
  }
  Geodetic centre() const {
    return geodetic_from_degrees(west_deg + width_deg() / 2, (south_deg + north_deg) / 2);
  }
};

struct MapGrid {
  std::string crs;  // WKT
  std::array<double, 6> geotransform{};
  int columns = 0;
  int rows = 0;

  RasterMap map(const Body& body) const;
};

// Square cells of that size around the whole window, north up about its centre: equirectangular,
// beyond 60 degrees of latitude polar stereographic; on Earth UTM or transverse Mercator, beyond 80
// degrees polar stereographic. Throws InputError when there would be too many. `values`: number of
// values held for each cell.
MapGrid grid_of_window(const Body& body, const MapWindow& window, double resolution_m,
                       int values = 1);
// Square cells of a stereographic map about a place, which is its origin: metres east and north of
// it. There must not be too many (asserted).
MapGrid grid_about(const Body& body, const Geodetic& origin, double west_m, double south_m,
                   double east_m, double north_m, double resolution_m);
// WKT of the body's geographic CRS.
std::string geographic_wkt(const Body& body);
// Grid of the raster's own cells, only those about the window where there is one. Throws InputError
// when the window lies elsewhere or holds too many cells.
MapGrid grid_of_raster(const Raster& raster, const std::optional<MapWindow>& window,
                       const RasterName& name, int values = 1);

}  // namespace lsos
