#include "record/gpkg.h"

#include <cpl_conv.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

#include "access/file_access.h"
#include "access/gdal_access.h"
#include "base/error.h"
#include "record/sqlite.h"
#include "record/stored_value.h"

namespace lsos::gpkg {

QuietErrors::QuietErrors() { CPLPushErrorHandlerEx(&QuietErrors::handle, this); }
QuietErrors::~QuietErrors() { CPLPopErrorHandler(); }

void QuietErrors::handle(CPLErr severity, CPLErrorNum, const char* text) {
  auto* self = static_cast<QuietErrors*>(CPLGetErrorHandlerUserData());
  if (severity >= CE_Failure && self->message_.empty()) self->message_ = text;
}

namespace {

// GDAL puts the whole statement into its messages; what failed stands at the end.
std::string without_statement(const std::string& message) {
  for (const std::string_view mark : {") failed: ", "):\n  "}) {
    const std::size_t at = message.rfind(mark);
    if (at != std::string::npos) return message.substr(at + mark.size());
  }
  return message;
}

// SQLite's reasons that a user can do something about, in plain words.
constexpr std::pair<std::string_view, std::string_view> plain_words[]{
    {"database or disk is full", "no space is left on the disk"},
    {"disk I/O error", "the disk reports an error, or a limit of file sizes is reached"},
    {"database is locked", "another program has kept it locked for half a minute"},
    {"attempt to write a readonly database", "it may be read only"},
    {"database disk image is malformed", "it is damaged: another program has written into it"}};

}  // namespace

std::string QuietErrors::message() const {
  if (message_.empty()) return "the GeoPackage driver gives no reason";
  const std::string reason = without_statement(message_);
  const auto* const known = std::ranges::find_if(
      plain_words, [&](const auto& entry) { return reason.ends_with(entry.first); });
  return known == std::end(plain_words) ? reason : std::string(known->second);
}

namespace {

GDALDriver* geopackage_driver() {
  static GDALDriver* driver = [] {
    register_drivers();
    return GetGDALDriverManager()->GetDriverByName("GPKG");
  }();
  return driver;
}

OGRFieldType field_type(ColumnType type) {
  switch (type) {
    case ColumnType::integer:
      return OFTInteger64;
    case ColumnType::real:
      return OFTReal;
    case ColumnType::utc:
      return OFTDateTime;
    case ColumnType::text:
      break;
  }
  return OFTString;
}

OGRwkbGeometryType geometry_type(LayerGeometry geometry) {
  switch (geometry) {
    case LayerGeometry::point:
      return wkbPoint25D;
    case LayerGeometry::line:
      return wkbLineString25D;
    case LayerGeometry::none:
      break;
  }
  return wkbNone;
}

// Only a write-ahead log leaves the file readable after kill -9. With NORMAL a power loss may cost
// the last commits, a kill does not.
struct WriteAheadLog {
  CPLConfigOptionSetter journal{"OGR_SQLITE_JOURNAL", "WAL", false};
  CPLConfigOptionSetter synchronous{"OGR_SQLITE_SYNCHRONOUS", "NORMAL", false};
  // A GIS that saves edits locks the file for some seconds.
  CPLConfigOptionSetter patience{"SQLITE_BUSY_TIMEOUT", "30000", false};  // ms
};

constexpr int zone_utc = 100;  // GDAL's number of the time zone

void set_utc(OGRFeature& feature, int field, const std::string& text) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0;
  float second = 0;  // GDAL's type; exact to far less than a millisecond
  const int count =
      std::sscanf(text.c_str(), "%d-%d-%dT%d:%d:%fZ", &year, &month, &day, &hour, &minute, &second);
  LSOS_ASSERT(count == 6);
  feature.SetField(field, year, month, day, hour, minute, second, zone_utc);
}

}  // namespace

Dataset create(const std::string& file) {
  allow_file(file);
  const WriteAheadLog settings;  // before the file exists
  return create_at(file);
}

Dataset create_at(const std::string& file) {
  GDALDriver* driver = geopackage_driver();
  if (driver == nullptr) return nullptr;
  CPLStringList options;
  // GDAL writes its table of row counts only on closing: other readers would find wrong counts.
  options.SetNameValue("ADD_GPKG_OGR_CONTENTS", "NO");
  return Dataset(driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, options.List()));
}

Dataset open_to_write(const std::string& file) {
  if (geopackage_driver() == nullptr) return nullptr;
  allow_file(file);
  const WriteAheadLog settings;
  const char* const drivers[] = {"GPKG", nullptr};
  Dataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, drivers));
  if (dataset == nullptr) return nullptr;
  // The log may come from elsewhere, with triggers that would run with what is written.
  auto* handle = static_cast<sqlite3*>(dataset->GetInternalHandle("SQLITE_HANDLE"));
  if (handle == nullptr) return nullptr;
  sqlite::harden(handle);
  return dataset;
}

std::string size_fault(const std::string& file, std::uintmax_t bytes_max) {
  constexpr double gb = 1e9;
  std::uintmax_t bytes = 0;
  for (const char* part : {"", "-wal"}) {
    std::error_code absent;
    const std::uintmax_t size = std::filesystem::file_size(file + part, absent);
    if (!absent) bytes += size;
  }
  if (bytes_max == 0 || bytes <= bytes_max) return "";
  return fmt::format(
      "{}: takes {:.3g} GB, where {:.3g} GB are allowed; --log-max allows more, and lsos-host "
      "resume then goes on",
      file, static_cast<double>(bytes) / gb, static_cast<double>(bytes_max) / gb);
}

OGRLayer* create_layer(GDALDataset& dataset, const LayerSpec& spec, OGRSpatialReference& crs) {
  CPLStringList options;
  options.SetNameValue("FID", "fid");
  options.SetNameValue("GEOMETRY_NAME", "geom");
  // Maintaining an index costs more than writing the rows.
  options.SetNameValue("SPATIAL_INDEX", "NO");
  const bool is_spatial = spec.geometry != LayerGeometry::none;
  OGRLayer* layer = dataset.CreateLayer(std::string(spec.name).c_str(), is_spatial ? &crs : nullptr,
                                        geometry_type(spec.geometry), options.List());
  if (layer == nullptr) return nullptr;
  for (const ColumnSpec& column : spec.columns) {
    OGRFieldDefn field(std::string(column.name).c_str(), field_type(column.type));
    if (layer->CreateField(&field) != OGRERR_NONE) return nullptr;
  }
  return layer;
}

std::string quoted(const std::string& text) {
  std::string sql = "'";
  for (const char c : text) sql += c == '\'' ? std::string("''") : std::string(1, c);
  return sql + "'";
}

void run_sql(GDALDataset& dataset, const std::string& statement,
             const std::function<void(const OGRFeature&)>& visit) {
  OGRLayer* result = dataset.ExecuteSQL(statement.c_str(), nullptr, nullptr);
  if (result == nullptr) return;
  while (const Feature feature{result->GetNextFeature()}) {
    if (visit) visit(*feature);
  }
  dataset.ReleaseResultSet(result);
}

void set_value(OGRFeature& feature, int field, const ColumnValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    feature.SetField(field, *real);
  } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    feature.SetField(field, static_cast<GIntBig>(*integer));
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    if (feature.GetFieldDefnRef(field)->GetType() == OFTDateTime) {
      set_utc(feature, field, *text);
    } else {
      feature.SetField(field, text->c_str());
    }
  } else {
    feature.SetFieldNull(field);
  }
}

void set_point(OGRFeature& feature, const std::optional<Geodetic>& place) {
  if (!place || !is_place(lon_deg(*place), lat_deg(*place), place->height_m)) {
    feature.SetGeometryDirectly(nullptr);
    return;
  }
  if (feature.GetGeometryRef() == nullptr) feature.SetGeometryDirectly(new OGRPoint(0, 0, 0));
  OGRPoint* point = feature.GetGeometryRef()->toPoint();
  point->setX(lon_deg(*place));
  point->setY(lat_deg(*place));
  point->setZ(place->height_m);
}

void set_line(OGRFeature& feature, const std::vector<Geodetic>& line) {
  auto geometry = std::make_unique<OGRLineString>();
  // All at once: addPoint() copies what is there for each.
  geometry->setNumPoints(static_cast<int>(line.size()));
  int index = 0;
  for (const Geodetic& place : line) {
    geometry->setPoint(index++, lon_deg(place), lat_deg(place), place.height_m);
  }
  feature.SetGeometryDirectly(geometry.release());
}

}  // namespace lsos::gpkg
