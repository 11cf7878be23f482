#include "record/table_file_reader.h"

#include <fmt/format.h>

#include "access/file_access.h"
#include "access/gdal_access.h"
#include "base/error.h"
#include "record/gpkg.h"

namespace lsos {

namespace {

// Tables have no times of the calendar.
ColumnType column_type(const OGRFieldDefn& field) {
  switch (field.GetType()) {
    case OFTInteger:
    case OFTInteger64:
      return ColumnType::integer;
    case OFTReal:
      return ColumnType::real;
    default:
      return ColumnType::text;
  }
}

ColumnValue value_of(const OGRFeature& feature, int field, ColumnType type) {
  if (!feature.IsFieldSetAndNotNull(field)) return {};
  if (type == ColumnType::integer) return std::int64_t{feature.GetFieldAsInteger64(field)};
  if (type == ColumnType::real) return feature.GetFieldAsDouble(field);
  return std::string(feature.GetFieldAsString(field));
}

std::optional<Geodetic> place_of(const OGRFeature& feature) {
  const OGRGeometry* geometry = feature.GetGeometryRef();
  if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbPoint) return {};
  const OGRPoint* point = geometry->toPoint();
  if (point->IsEmpty()) return {};
  return geodetic_from_degrees(point->getX(), point->getY(), point->getZ());
}

gpkg::Dataset open_to_read(const std::string& file) {
  register_drivers();
  allow_file(file);
  const char* const drivers[] = {"GPKG", nullptr};
  return gpkg::Dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
}

}  // namespace

struct TableFileReader::Impl {
  std::string file;
  gpkg::Dataset dataset;

  OGRLayer& layer(const std::string& name) const {
    OGRLayer* found = dataset->GetLayerByName(name.c_str());
    if (found == nullptr) throw InputError({file}, fmt::format("has no layer '{}'", name));
    return *found;
  }
};

TableFileReader::TableFileReader(const std::string& file) : impl_(std::make_unique<Impl>()) {
  const gpkg::QuietErrors errors;
  impl_->file = file;
  impl_->dataset = open_to_read(file);
  if (!impl_->dataset) throw InputError({file}, errors.message());
}

TableFileReader::~TableFileReader() = default;

std::vector<TableColumn> TableFileReader::columns(const std::string& layer) const {
  const gpkg::QuietErrors errors;
  OGRFeatureDefn& definition = *impl_->layer(layer).GetLayerDefn();
  std::vector<TableColumn> columns;
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    const OGRFieldDefn& field = *definition.GetFieldDefn(i);
    columns.push_back({field.GetNameRef(), column_type(field)});
  }
  return columns;
}

std::vector<FileRow> TableFileReader::rows(const std::string& layer) const {
  const std::vector<TableColumn> of = columns(layer);
  const gpkg::QuietErrors errors;
  OGRLayer& source = impl_->layer(layer);
  source.ResetReading();
  std::vector<FileRow> rows;
  while (const gpkg::Feature feature{source.GetNextFeature()}) {
    FileRow row;
    for (std::size_t i = 0; i < of.size(); ++i) {
      row.values.push_back(value_of(*feature, static_cast<int>(i), of[i].type));
    }
    row.place = place_of(*feature);
    rows.push_back(std::move(row));
  }
  if (errors.has_failed()) {
    throw InputError({impl_->file}, "cannot be read: " + errors.message());
  }
  return rows;
}

}  // namespace lsos
