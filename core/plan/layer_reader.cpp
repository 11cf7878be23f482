#include "plan/layer_reader.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <optional>

#include "access/file_access.h"
#include "access/gdal_access.h"
#include "base/error.h"
#include "terrain/raster/gdal_call.h"
#include "terrain/raster/raster_body.h"
#include "terrain/raster/raster_map.h"

namespace lsos {

namespace {

// Whether the layer holds nothing drawn: QGIS stores data of its own in two tables, and GDAL gives
// the points of the routes and tracks of a GPX file once more.
bool is_left_out(std::string_view layer) {
  return layer == "layer_styles" || layer == "qgis_projects" || layer == "route_points" ||
         layer == "track_points";
}

bool is_name_column(std::string name) {
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name == "name";
}

// ISO 8601, "2026-07-01T06:00:00.500Z". A time without a zone is UTC, as in texts of a plan.
std::string date_text(const OGRFeature& feature, int field, bool has_time) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, zone = 0;
  float second = 0;
  feature.GetFieldAsDateTime(field, &year, &month, &day, &hour, &minute, &second, &zone);
  std::string date = fmt::format("{:04}-{:02}-{:02}", year, month, day);
  if (!has_time) return date;
  constexpr int utc = 100;  // zones count quarters of an hour from here; 0 and 1: unknown
  const int offset_min = zone > 1 ? (zone - utc) * 15 : 0;
  const std::string offset =
      offset_min == 0 ? "Z"
                      : fmt::format("{}{:02}:{:02}", offset_min < 0 ? '-' : '+',
                                    std::abs(offset_min) / 60, std::abs(offset_min) % 60);
  return fmt::format("{}T{:02}:{:02}:{:06.3f}{}", date, hour, minute, second, offset);
}

std::string column_text(const OGRFeature& feature, int field) {
  switch (feature.GetFieldDefnRef(field)->GetType()) {
    case OFTDate:
      return date_text(feature, field, false);
    case OFTDateTime:
      return date_text(feature, field, true);
    case OFTReal:
      return fmt::format("{}", feature.GetFieldAsDouble(field));
    case OFTInteger:
    case OFTInteger64:
      return fmt::format("{}", feature.GetFieldAsInteger64(field));
    default:
      return feature.GetFieldAsString(field);
  }
}

// Converts the coordinates of one layer to degrees.
class LayerPlaces {
 public:
  LayerPlaces(const OGRSpatialReference* crs, const std::string& layer) {
    if (crs == nullptr) return;
    OGRSpatialReference east_first = *crs;
    east_first.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    map_.emplace(east_first, RasterName{{}, layer});
    is_geographic_ = east_first.IsGeographic() != 0;
  }

  // Name of the body; "" without a CRS: the coordinates then are degrees.
  std::string body() const { return map_ ? map_->body.name : ""; }
  bool is_geographic() const { return is_geographic_; }

  // "lon,lat"; as written when the map has no such place, which is reported when the text is read.
  std::string text(double x, double y) const {
    const std::optional<Geodetic> place = map_ ? map_->map.place({x, y}) : std::nullopt;
    if (!place) return fmt::format("{},{}", x, y);
    return fmt::format("{},{}", rounded(lon_deg(*place)), rounded(lat_deg(*place)));
  }

 private:
  // Rounds to 1e-9 degrees, a tenth of a millimetre: PROJ's rounding errors do not enter the plan.
  static double rounded(double angle_deg) { return std::round(angle_deg * 1e9) / 1e9 + 0.0; }

  struct Map {
    MapBody body;
    RasterMap map;

    // The geotransform makes columns and rows equal the map's coordinates.
    Map(const OGRSpatialReference& crs, const RasterName& name)
        : body(body_of(crs, name)), map(crs, {-0.5, 1, 0, -0.5, 0, 1}, 1, body.body, name) {}
  };
  std::optional<Map> map_;
  bool is_geographic_ = true;
};

std::string coordinates_of(const OGRSimpleCurve& curve, const LayerPlaces& places) {
  std::string text;
  for (int i = 0; i < curve.getNumPoints(); ++i) {
    text += (i == 0 ? "" : " ") + places.text(curve.getX(i), curve.getY(i));
  }
  return text;
}

SourceGeometry geometry_of(const OGRGeometry& geometry, const LayerPlaces& places, int line) {
  SourceGeometry found{"", "", line};
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPoint:
      found.kind = "Point";
      found.coordinates = places.text(geometry.toPoint()->getX(), geometry.toPoint()->getY());
      break;
    case wkbLineString:
      found.kind = "LineString";
      found.coordinates = coordinates_of(*geometry.toLineString(), places);
      break;
    case wkbPolygon: {
      found.kind = "Polygon";
      const OGRPolygon& polygon = *geometry.toPolygon();
      found.coordinates = coordinates_of(*polygon.getExteriorRing(), places);
      for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
        found.holes.push_back({coordinates_of(*polygon.getInteriorRing(i), places), line});
      }
      break;
    }
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection: {
      // Empty parts do not count.
      const OGRGeometryCollection& several = *geometry.toGeometryCollection();
      const OGRGeometry* only = nullptr;
      int parts = 0;
      for (const OGRGeometry* part : several) {
        if (part->IsEmpty()) continue;
        only = part;
        ++parts;
      }
      if (parts == 1) return geometry_of(*only, places, line);
      found.kind = "MultiGeometry";
      break;
    }
    default:
      found.kind = geometry.getGeometryName();
  }
  return found;
}

SourcePlacemark placemark_of(const OGRFeature& feature, const std::string& layer,
                             const LayerPlaces& places, const std::string& file) {
  SourcePlacemark placemark;
  placemark.file = file;
  placemark.line = static_cast<int>(feature.GetFID());
  placemark.folders = {layer};
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    if (!feature.IsFieldSetAndNotNull(i)) continue;
    const std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
    std::string text = column_text(feature, i);
    if (is_name_column(name)) placemark.name = text;
    placemark.plain_data.push_back({name, std::move(text), placemark.line});
  }
  const OGRGeometry* geometry = feature.GetGeometryRef();
  if (geometry == nullptr || geometry->IsEmpty()) return placemark;
  const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
  placemark.geometries.push_back(geometry_of(*straight, places, placemark.line));
  return placemark;
}

}  // namespace

bool is_geopackage(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("SQLite format 3\0"sv);
}

namespace {

// `what` it is that cannot be opened: "is no GPX file".
KmlSource read(const std::string& file, const char* driver, const std::string& what) {
  const GdalSilence silence;
  register_drivers();
  allow_file(file);
  const char* const drivers[] = {driver, nullptr};
  CPLStringList options;
  // Times of GeoJSON are texts, and stay so: seconds of GDAL's own times are single precision.
  if (drivers[0] == std::string_view("GeoJSON")) options.SetNameValue("DATE_AS_STRING", "YES");
  const Dataset dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options.List()));
  if (dataset == nullptr) {
    throw InputError({file, 0}, fmt::format("{}: {}", what, GdalSilence::message()));
  }
  KmlSource source{file, {}};
  for (int i = 0; i < dataset->GetLayerCount(); ++i) {
    OGRLayer& layer = *dataset->GetLayer(i);
    const std::string name = layer.GetName();
    if (is_left_out(name)) continue;
    const std::string layer_file = fmt::format("{}/{}", file, name);
    const LayerPlaces places(layer.GetSpatialRef(), layer_file);
    if (layer.GetGeomType() != wkbNone) {
      source.layers.push_back({layer_file, places.body(), places.is_geographic()});
    }
    layer.ResetReading();
    while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
      source.placemarks.push_back(placemark_of(*feature, name, places, layer_file));
    }
  }
  return source;
}

}  // namespace

KmlSource read_layers(const std::string& file) {
  // GDAL opens the file itself, not its bytes: while QGIS has it open, the last edits are in a
  // separate file beside it.
  return read(file, "GPKG", "is an SQLite database but no GeoPackage with layers");
}

KmlSource read_layers(const std::string& file, const std::string& driver) {
  return read(file, driver.c_str(), fmt::format("cannot be read as {}", driver));
}

}  // namespace lsos
