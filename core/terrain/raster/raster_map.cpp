#include "terrain/raster/raster_map.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

bool is_cylindrical(const OGRSpatialReference& crs) {
  if (crs.IsGeographic()) return true;
  const char* projection = crs.GetAttrValue("PROJECTION");
  if (projection == nullptr) return false;
  const std::string_view name = projection;
  return name == SRS_PT_EQUIRECTANGULAR || name == SRS_PT_MERCATOR_1SP ||
         name == SRS_PT_MERCATOR_2SP || name == SRS_PT_CYLINDRICAL_EQUAL_AREA ||
         name == SRS_PT_MILLER_CYLINDRICAL;
}

}  // namespace

// Projection from longitude and latitude of the raster's own datum to its CRS. PROJ never gets a
// transformation between bodies or spheres, which it refuses: a place has the same planetocentric
// longitude and latitude on every sphere of one body.
struct RasterMap::Projection {
  OGRSpatialReference crs;
  OGRSpatialReference geographic;
  std::unique_ptr<OGRCoordinateTransformation> forward;
  std::unique_ptr<OGRCoordinateTransformation> inverse;
  double degrees_per_rad = 180 / std::numbers::pi;
  double longitude_sign = 1;  // -1: the datum counts longitude westwards
  double prime_meridian_deg = 0;
  // (1 - f)^2 where latitudes of the datum are planetographic but those of the body planetocentric.
  double centric_per_graphic_tan = 1;

  // Makes the data axes of `geographic` longitude, latitude, whatever their order and sense.
  void order_axes() {
    OGRAxisOrientation first = OAO_Other;
    OGRAxisOrientation second = OAO_Other;
    geographic.GetAxis(nullptr, 0, &first);
    geographic.GetAxis(nullptr, 1, &second);
    const bool latitude_first = first == OAO_North || first == OAO_South;
    const OGRAxisOrientation longitude = latitude_first ? second : first;
    if (longitude == OAO_West) longitude_sign = -1;
    geographic.SetDataAxisToSRSAxisMapping(latitude_first ? std::vector<int>{2, 1}
                                                          : std::vector<int>{1, 2});
  }

  bool has_planetocentric_latitudes() const {
    char* wkt = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    geographic.exportToWkt(&wkt, options);
    const bool spherical =
        wkt != nullptr && std::string_view(wkt).find("CS[spherical") != std::string_view::npos;
    CPLFree(wkt);
    return spherical;
  }
};

RasterMap::RasterMap(const OGRSpatialReference& crs, const std::array<double, 6>& geotransform,
                     int columns, const Body& body, const RasterName& name)
    : geotransform_(geotransform), projection_(std::make_unique<Projection>()), columns_(columns) {
  const GdalSilence silence;
  LSOS_ASSERT(GDALInvGeoTransform(geotransform_.data(), inverse_.data()));
  Projection& projection = *projection_;
  projection.crs = crs;
  if (body.flattening != 0) {
    projection.geographic.importFromEPSG(4326);
  } else {
    const std::unique_ptr<OGRSpatialReference> own(projection.crs.CloneGeogCS());
    if (own == nullptr) name.refuse("has a coordinate reference system without a geographic base");
    projection.geographic = *own;
    projection.prime_meridian_deg = own->GetPrimeMeridian();
    projection.degrees_per_rad = 1 / own->GetAngularUnits();
    const double inverse_flattening = own->GetInvFlattening();
    if (inverse_flattening > 0 && !projection.has_planetocentric_latitudes()) {
      const double polar = 1 - 1 / inverse_flattening;
      projection.centric_per_graphic_tan = polar * polar;
    }
  }
  projection.order_axes();
  projection.forward.reset(
      OGRCreateCoordinateTransformation(&projection.geographic, &projection.crs));
  if (projection.forward != nullptr) projection.inverse.reset(projection.forward->GetInverse());
  if (projection.inverse == nullptr) {
    name.refuse(fmt::format("has a coordinate reference system that PROJ cannot use: {}",
                            GdalSilence::message()));
  }
  find_period(columns_);
}

RasterMap::~RasterMap() = default;

void RasterMap::find_period(int columns) {
  const bool is_north_up = geotransform_[2] == 0 && geotransform_[4] == 0;
  if (!is_north_up || !is_cylindrical(projection_->crs)) return;
  // Two quarter turns are measured. The projection may be cut anywhere, but the cut widens one of
  // them at most, and the smaller counts.
  double smallest_px = std::numeric_limits<double>::infinity();
  for (int quarter = 0; quarter < 2; ++quarter) {
    const double lon_rad = 0.1 + quarter * std::numbers::pi / 2;
    const auto a = coordinates({lon_rad, 0, 0});
    const auto b = coordinates({lon_rad + std::numbers::pi / 2, 0, 0});
    if (!a || !b) return;
    smallest_px = std::min(smallest_px, std::abs(b->u - a->u));
  }
  period_px_ = 4 * smallest_px;
  // A raster that is meant to go around, but whose cell size was rounded, does go around; so does
  // one whose last columns repeat its first.
  const double whole_px = std::round(period_px_);
  if (whole_px <= columns && std::abs(period_px_ - whole_px) < 1e-3 * columns / 360) {
    period_px_ = whole_px;
  }
}

std::optional<GridCoordinates> RasterMap::coordinates(const Geodetic& place) const {
  const Projection& projection = *projection_;
  const double lat_rad =
      projection.centric_per_graphic_tan == 1
          ? place.lat_rad
          : std::atan2(std::sin(place.lat_rad),
                       std::cos(place.lat_rad) * projection.centric_per_graphic_tan);
  double x = projection.longitude_sign * place.lon_rad * projection.degrees_per_rad -
             projection.prime_meridian_deg;
  double y = lat_rad * projection.degrees_per_rad;
  int success = FALSE;
  {
    const std::lock_guard lock(mutex_);
    const GdalSilence silence;
    projection.forward->Transform(1, &x, &y, nullptr, &success);
  }
  if (!success || !std::isfinite(x) || !std::isfinite(y)) return {};
  // Geotransforms count from the corner of the first cell, grid coordinates from its centre.
  return GridCoordinates{inverse_[0] + inverse_[1] * x + inverse_[2] * y - 0.5,
                         inverse_[3] + inverse_[4] * x + inverse_[5] * y - 0.5};
}

MapPoint RasterMap::map_point(const GridCoordinates& at) const {
  const auto& g = geotransform_;
  return {g[0] + g[1] * (at.u + 0.5) + g[2] * (at.v + 0.5),
          g[3] + g[4] * (at.u + 0.5) + g[5] * (at.v + 0.5)};
}

const OGRSpatialReference& RasterMap::crs() const { return projection_->crs; }

std::optional<Geodetic> RasterMap::place(const GridCoordinates& at) const {
  const Projection& projection = *projection_;
  auto [x, y] = map_point(at);
  int success = FALSE;
  {
    const std::lock_guard lock(mutex_);
    const GdalSilence silence;
    projection.inverse->Transform(1, &x, &y, nullptr, &success);
  }
  if (!success || !std::isfinite(x) || !std::isfinite(y)) return {};
  constexpr double right_angle_rad = std::numbers::pi / 2;
  const double lon_rad =
      projection.longitude_sign * (x + projection.prime_meridian_deg) / projection.degrees_per_rad;
  double lat_rad = y / projection.degrees_per_rad;
  // Cylindrical rasters may have rows beyond a pole, which some projections take for latitudes.
  if (std::abs(lat_rad) > right_angle_rad + 1e-12) return {};
  if (projection.centric_per_graphic_tan != 1) {
    lat_rad = std::atan2(std::sin(lat_rad) * projection.centric_per_graphic_tan, std::cos(lat_rad));
  }
  return Geodetic{std::remainder(lon_rad, 2 * std::numbers::pi),
                  std::clamp(lat_rad, -right_angle_rad, right_angle_rad), 0};
}

std::string RasterMap::description() const {
  char* wkt = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  projection_->crs.exportToWkt(&wkt, options);
  std::string text = fmt::format("{} {}", fmt::join(geotransform_, " "), wkt);
  CPLFree(wkt);
  return text;
}

}  // namespace lsos
