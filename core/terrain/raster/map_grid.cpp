#include "terrain/raster/map_grid.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

// Greatest number of values of one map, which take a gigabyte while they are made.
constexpr double most_values = double{1 << 28};

OGRSpatialReference crs_of_wkt(const std::string& wkt) {
  OGRSpatialReference crs;
  LSOS_ASSERT(crs.importFromWkt(wkt.c_str()) == OGRERR_NONE);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string crs_about(const Body& body, const MapWindow& window) {
  const GdalSilence silence;
  OGRSpatialReference geographic;
  LSOS_ASSERT(geographic.SetFromUserInput(std::string(body.crs).c_str()) == OGRERR_NONE);
  const double centre_lon_deg = lon_deg(window.centre());
  const double centre_lat_deg = lat_deg(window.centre());
  OGRSpatialReference crs;
  crs.SetProjCS(
      fmt::format("{} about {:.4f},{:.4f}", body.name, centre_lon_deg, centre_lat_deg).c_str());
  crs.CopyGeogCSFrom(&geographic);
  const bool is_earth = body.flattening != 0;
  if (std::abs(centre_lat_deg) > (is_earth ? 80 : 60)) {
    const double meridian_deg = window.width_deg() > 180 ? 0 : centre_lon_deg;
    crs.SetPS(std::copysign(90, centre_lat_deg), meridian_deg, 1, 0, 0);
  } else if (!is_earth) {
    crs.SetEquirectangular2(0, centre_lon_deg, centre_lat_deg, 0, 0);
  } else if (window.width_deg() <= 6) {
    const int zone =
        std::clamp(static_cast<int>(std::floor((centre_lon_deg + 180) / 6)) + 1, 1, 60);
    crs.importFromEPSG((centre_lat_deg < 0 ? 32700 : 32600) + zone);
  } else {
    crs.SetTM(0, centre_lon_deg, 1, 0, 0);
  }
  return wkt_of(crs);
}

// Bounds of a window on a map, in its grid coordinates.
struct Bounds {
  double u_low = std::numeric_limits<double>::infinity();
  double v_low = u_low;
  double u_high = -u_low;
  double v_high = -u_low;

  // `period`: columns once around, or 0.
  Bounds(const RasterMap& map, const MapWindow& window, double period) {
    constexpr int steps = 360;
    // The window stays short of half a turn from the centre, where the map may be cut.
    const double width_deg = std::min(window.width_deg(), 360 - 1e-9);
    const double centre_deg = window.west_deg + window.width_deg() / 2;
    const auto centre = map.coordinates(window.centre());
    for (int i = 0; i <= steps; ++i) {
      const double along = static_cast<double>(i) / steps;
      const double lon_deg = centre_deg + (along - 0.5) * width_deg;
      const double lat_deg = window.south_deg + along * (window.north_deg - window.south_deg);
      add(map.coordinates(geodetic_from_degrees(lon_deg, window.south_deg)), centre, period);
      add(map.coordinates(geodetic_from_degrees(lon_deg, window.north_deg)), centre, period);
      for (const double side : {-0.5, 0.5}) {
        add(map.coordinates(geodetic_from_degrees(centre_deg + side * width_deg, lat_deg)), centre,
            period);
      }
    }
  }

 private:
  void add(const std::optional<GridCoordinates>& at, const std::optional<GridCoordinates>& centre,
           double period) {
    if (!at) return;
    double u = at->u;
    if (period > 0 && centre) u = centre->u + std::remainder(u - centre->u, period);
    u_low = std::min(u_low, u);
    u_high = std::max(u_high, u);
    v_low = std::min(v_low, at->v);
    v_high = std::max(v_high, at->v);
  }
};

}  // namespace

RasterMap MapGrid::map(const Body& body) const {
  return {crs_of_wkt(crs), geotransform, columns, body, {{}, "the map"}};
}

MapGrid grid_of_window(const Body& body, const MapWindow& window, double resolution_m, int values) {
  const double most_cells = most_values / values;
  MapGrid grid;
  grid.crs = crs_about(body, window);
  // One column and one row per metre: grid coordinates are those of the map, less half a metre.
  grid.geotransform = {0, 1, 0, 0, 0, 1};
  const Bounds bounds(grid.map(body), window, 0);
  const auto cells = [&](double length_m) {
    return std::max(2.0, std::ceil(length_m / resolution_m - 1e-6));
  };
  const double columns = cells(bounds.u_high - bounds.u_low);
  const double rows = cells(bounds.v_high - bounds.v_low);
  if (!(columns * rows <= most_cells)) {
    throw InputError(
        {},
        fmt::format("--resolution {}: the window has {:.0f} x {:.0f} cells of that size; {:.0f} "
                    "are allowed, as with --resolution {:.3g}",
                    resolution_m, columns, rows, most_cells,
                    1.001 * resolution_m * std::sqrt(columns * rows / most_cells)));
  }
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  grid.geotransform = {bounds.u_low + 0.5, resolution_m, 0, bounds.v_high + 0.5, 0, -resolution_m};
  return grid;
}

MapGrid grid_about(const Body& body, const Geodetic& origin, double west_m, double south_m,
                   double east_m, double north_m, double resolution_m) {
  const double columns = std::ceil((east_m - west_m) / resolution_m);
  const double rows = std::ceil((north_m - south_m) / resolution_m);
  LSOS_ASSERT(columns >= 1 && rows >= 1 && columns * rows <= most_values);
  const GdalSilence silence;
  OGRSpatialReference geographic;
  LSOS_ASSERT(geographic.SetFromUserInput(std::string(body.crs).c_str()) == OGRERR_NONE);
  OGRSpatialReference crs;
  crs.SetProjCS(
      fmt::format("{} about {:.4f},{:.4f}", body.name, lon_deg(origin), lat_deg(origin)).c_str());
  crs.CopyGeogCSFrom(&geographic);
  crs.SetStereographic(lat_deg(origin), lon_deg(origin), 1, 0, 0);
  MapGrid grid;
  grid.crs = wkt_of(crs);
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  grid.geotransform = {west_m, resolution_m, 0, south_m + rows * resolution_m, 0, -resolution_m};
  return grid;
}

std::string geographic_wkt(const Body& body) {
  const GdalSilence silence;
  OGRSpatialReference geographic;
  LSOS_ASSERT(geographic.SetFromUserInput(std::string(body.crs).c_str()) == OGRERR_NONE);
  return wkt_of(geographic);
}

MapGrid grid_of_raster(const Raster& raster, const std::optional<MapWindow>& window,
                       const RasterName& name, int values) {
  const double most_cells = most_values / values;
  const RasterMap& map = raster.map();
  int column_low = 0, row_low = 0;
  int column_high = raster.columns(), row_high = raster.rows();
  if (window) {
    const double period = map.period_px();
    Bounds bounds(map, *window, period);
    if (period > 0 && !raster.goes_around()) {
      const double turn = period * std::floor((bounds.u_high + 0.5) / period);
      bounds.u_low -= turn;
      bounds.u_high -= turn;
    }
    const auto cell = [](double value) { return static_cast<int>(std::floor(value + 0.5)); };
    const bool is_free = raster.goes_around();
    const double columns = raster.columns(), rows = raster.rows();
    const bool is_on = bounds.u_high >= (is_free ? bounds.u_high : -0.5) &&
                       bounds.u_low <= (is_free ? bounds.u_low : columns - 0.5) &&
                       bounds.v_high >= -0.5 && bounds.v_low <= rows - 0.5;
    if (!is_on) name.refuse("does not reach into the --window");
    column_low = is_free ? cell(bounds.u_low) : cell(std::max(bounds.u_low, 0.0));
    column_high = (is_free ? cell(bounds.u_high) : cell(std::min(bounds.u_high, columns - 1))) + 1;
    row_low = cell(std::max(bounds.v_low, 0.0));
    row_high = cell(std::min(bounds.v_high, rows - 1)) + 1;
  }
  MapGrid grid;
  grid.crs = wkt_of(map.crs());
  grid.columns = column_high - column_low;
  grid.rows = row_high - row_low;
  if (static_cast<double>(grid.columns) * grid.rows > most_cells) {
    name.refuse(
        fmt::format("has {} x {} cells there; {:.0f} are allowed at once: give a smaller "
                    "--window, or a --resolution",
                    grid.columns, grid.rows, most_cells));
  }
  const auto& g = map.geotransform();
  grid.geotransform = g;
  grid.geotransform[0] += g[1] * column_low + g[2] * row_low;
  grid.geotransform[3] += g[4] * column_low + g[5] * row_low;
  return grid;
}

}  // namespace lsos
