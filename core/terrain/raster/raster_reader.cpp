#include "terrain/raster/raster_reader.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "planet/site_frame.h"

namespace lsos {

namespace {

constexpr double full_turn_rad = 2 * std::numbers::pi;

double azimuth_rad(double east, double north) {
  const double azimuth = std::atan2(east, north);
  return azimuth < 0 ? azimuth + full_turn_rad : azimuth;
}

// Position of `to` as seen from `from`, east and north, m. Both lie on the reference surface.
struct Offset {
  double east_m, north_m;

  Offset(const Body& body, const Geodetic& from, const Geodetic& to) {
    const Vec3 d_F = p_F_m(body, to) - p_F_m(body, from);
    const double sin_lon = std::sin(from.lon_rad), cos_lon = std::cos(from.lon_rad);
    const double sin_lat = std::sin(from.lat_rad), cos_lat = std::cos(from.lat_rad);
    east_m = -sin_lon * d_F.x() + cos_lon * d_F.y();
    north_m = cos_lat * d_F.z() - sin_lat * (cos_lon * d_F.x() + sin_lon * d_F.y());
  }
};

// Horn's rises per column and per row from three rows of three samples, summed in gdaldem's order.
template <class Sum>
std::pair<double, double> horn_differences(const std::array<double, 9>& samples) {
  std::array<Sum, 9> z{};
  std::ranges::transform(samples, z.begin(), [](double s) { return static_cast<Sum>(s); });
  const Sum east = z[2] + z[5] + z[5] + z[8];
  const Sum west = z[0] + z[3] + z[3] + z[6];
  const Sum south = z[6] + z[7] + z[7] + z[8];
  const Sum north = z[0] + z[1] + z[1] + z[2];
  return {static_cast<double>(east - west) / 8, static_cast<double>(south - north) / 8};
}

}  // namespace

RasterReader::RasterReader(const RasterSurface& surface, const Place& place, const Body* body)
    : body_(body), raster_(surface, place, body) {
  if (body_ == nullptr) body_ = &raster_.own_body();
}

std::string RasterReader::crs_unit() const {
  const OGRSpatialReference& crs = raster_.map().crs();
  const char* name = nullptr;
  if (crs.IsGeographic()) {
    crs.GetAngularUnits(&name);
    return std::string(name) == "degree" ? "deg" : name;
  }
  return crs.GetLinearUnits(&name) == 1 ? "m" : name;
}

std::optional<RasterPoint> RasterReader::at(const Geodetic& place) const {
  auto at = raster_.map().coordinates(place);
  if (!at) return {};
  const double period = raster_.map().period_px();
  const GridCoordinates outside = *at;
  if (period > 0) at->u -= period * std::floor((at->u + 0.5) / period);
  const bool is_inside = at->u >= -0.5 && at->u <= raster_.columns() - 0.5 && at->v >= -0.5 &&
                         at->v <= raster_.rows() - 0.5;
  RasterPoint point;
  point.map = raster_.map().map_point(is_inside ? *at : outside);
  if (!is_inside) return point;
  point.height_m = bilinear_m(*at);
  add_horn(*at, point);
  return point;
}

// Sample as it is written; NaN beyond the raster and where it is missing.
double RasterReader::sample(int column, int row) const {
  const int columns = raster_.columns();
  if (raster_.goes_around()) column = (column % columns + columns) % columns;
  if (column < 0 || column >= columns || row < 0 || row >= raster_.rows()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double height_m = raster_.heights_m({column, row, 1, 1})[0];
  return std::isnan(height_m) ? height_m : raster_.band().samples({column, row, 1, 1})[0];
}

std::optional<double> RasterReader::bilinear_m(const GridCoordinates& at) const {
  // A point given as a cell's centre, but for rounding, uses that cell alone.
  constexpr double rounding = 1e-6;
  const auto split = [](double value, int& cell) {
    cell = static_cast<int>(std::floor(value));
    const double along = value - cell;
    if (along > 1 - rounding) ++cell;
    return along < rounding || along > 1 - rounding ? 0 : along;
  };
  int column = 0;
  int row = 0;
  const double u = raster_.goes_around() ? at.u : std::clamp(at.u, 0.0, raster_.columns() - 1.0);
  const double along_u = split(u, column);
  const double along_v = split(std::clamp(at.v, 0.0, raster_.rows() - 1.0), row);
  double mean = 0;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = (i == 0 ? 1 - along_u : along_u) * (j == 0 ? 1 - along_v : along_v);
      if (weight > 0) mean += weight * sample(column + i, row + j);
    }
  }
  const HeightScale& scale = raster_.band().scale();
  return std::isnan(mean) ? std::nullopt : std::optional(mean * scale.scale + scale.offset_m);
}

// Slope and aspect by Horn (1981): weights 1, 2, 1 across the difference. At the raster's edge and
// beside missing samples there is none, as in gdaldem. Floating-point samples are added as gdaldem
// adds them, in 32 bits: at 4 km of height that turns a gentle slope's aspect by 0.1 degrees, and
// who compares must find the same. The ground's normal is free of it.
void RasterReader::add_horn(const GridCoordinates& at, RasterPoint& point) const {
  const auto nearest = [](double value, int count) {
    return std::clamp(static_cast<int>(std::floor(value + 0.5)), 0, count - 1);
  };
  const int column = nearest(at.u, raster_.columns());
  const int row = nearest(at.v, raster_.rows());
  std::array<double, 9> samples{};
  for (int k = 0; k < 9; ++k) {
    samples[k] = sample(column + k % 3 - 1, row + k / 3 - 1);
    if (std::isnan(samples[k])) return;
  }
  const auto [by_column, by_row] = raster_.band().is_floating_point()
                                       ? horn_differences<float>(samples)
                                       : horn_differences<double>(samples);
  const double by_column_m = by_column * raster_.band().scale().scale;
  const double by_row_m = by_row * raster_.band().scale().scale;
  const GridCoordinates cell{static_cast<double>(column), static_cast<double>(row)};
  const auto size = cell_size(cell);
  if (!size) return;
  const double area_m2 =
      size->east_by_column_m * size->north_by_row_m - size->east_by_row_m * size->north_by_column_m;
  const double by_east =
      (by_column_m * size->north_by_row_m - by_row_m * size->north_by_column_m) / area_m2;
  const double by_north =
      (by_row_m * size->east_by_column_m - by_column_m * size->east_by_row_m) / area_m2;
  if (!std::isfinite(by_east) || !std::isfinite(by_north)) return;
  point.slope_rad = std::atan(std::hypot(by_east, by_north));
  if (by_east == 0 && by_north == 0) return;
  point.aspect_grid_rad = azimuth_rad(-by_east, -by_north);
  if (const auto north_rad = north_azimuth_rad(cell)) {
    point.aspect_rad = std::fmod(*point.aspect_grid_rad + *north_rad, full_turn_rad);
  }
}

std::optional<RasterReader::CellSize> RasterReader::cell_size(const GridCoordinates& cell) const {
  const RasterMap& map = raster_.map();
  const auto& g = map.geotransform();
  if (!map.crs().IsGeographic()) {
    const double to_m = map.crs().GetLinearUnits();
    return CellSize{g[1] * to_m, g[2] * to_m, g[4] * to_m, g[5] * to_m};
  }
  const auto centre = map.place(cell);
  const auto next_column = map.place({cell.u + 0.5, cell.v});
  const auto last_column = map.place({cell.u - 0.5, cell.v});
  const auto next_row = map.place({cell.u, cell.v + 0.5});
  const auto last_row = map.place({cell.u, cell.v - 0.5});
  if (!centre || !next_column || !last_column || !next_row || !last_row) return {};
  const auto between = [&](const Geodetic& from, const Geodetic& to) {
    const Offset a(*body_, *centre, from), b(*body_, *centre, to);
    return std::pair{b.east_m - a.east_m, b.north_m - a.north_m};
  };
  const auto [column_east_m, column_north_m] = between(*last_column, *next_column);
  const auto [row_east_m, row_north_m] = between(*last_row, *next_row);
  return CellSize{column_east_m, row_east_m, column_north_m, row_north_m};
}

// Azimuth of the map's y axis, clockwise from true north.
std::optional<double> RasterReader::north_azimuth_rad(const GridCoordinates& cell) const {
  const RasterMap& map = raster_.map();
  if (map.crs().IsGeographic()) return 0;
  const auto& g = map.geotransform();
  // Half a cell's height along the y axis, as steps in column and row.
  const double determinant = g[1] * g[5] - g[2] * g[4];
  const double half = std::sqrt(std::abs(determinant)) / 2;
  const double by_u = -g[2] / determinant * half;
  const double by_v = g[1] / determinant * half;
  const auto centre = map.place(cell);
  const auto north = map.place({cell.u + by_u, cell.v + by_v});
  const auto south = map.place({cell.u - by_u, cell.v - by_v});
  if (!centre || !north || !south) return {};
  const Offset up(*body_, *centre, *north), down(*body_, *centre, *south);
  return azimuth_rad(up.east_m - down.east_m, up.north_m - down.north_m);
}

}  // namespace lsos
