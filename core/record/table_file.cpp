#include "record/table_file.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/files.h"
#include "base/output_error.h"
#include "record/gpkg.h"

namespace lsos {

struct TableFile::Impl {
  std::string file, part;
  OGRSpatialReference crs;
  gpkg::Dataset dataset;
  OGRLayer* layer = nullptr;
  gpkg::Feature feature;

  [[noreturn]] void fail(const gpkg::QuietErrors& errors) {
    feature.reset();
    dataset.reset();
    throw OutputError(fmt::format("{}: {}", file, errors.message()));
  }
};

TableFile::TableFile(const std::string& file, const std::string& crs)
    : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->part = file + std::string(part_suffix);
  for (const char* more : {"", "-wal", "-shm"}) std::remove((impl_->part + more).c_str());
  const gpkg::QuietErrors errors;
  impl_->crs.SetFromUserInput(crs.c_str());
  impl_->crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  impl_->dataset = gpkg::create(impl_->part);
  if (!impl_->dataset || impl_->dataset->StartTransaction() != OGRERR_NONE) impl_->fail(errors);
}

TableFile::~TableFile() {
  if (impl_->dataset == nullptr) return;
  impl_->feature.reset();
  impl_->dataset.reset();
  for (const char* more : {"", "-wal", "-shm"}) std::remove((impl_->part + more).c_str());
}

void TableFile::begin(const TableLayer& layer) {
  const gpkg::QuietErrors errors;
  LayerSpec spec{layer.name, layer.geometry, {}};
  for (const TableColumn& column : layer.columns)
    spec.columns.push_back({column.name, column.type});
  impl_->feature.reset();
  impl_->layer = gpkg::create_layer(*impl_->dataset, spec, impl_->crs);
  if (impl_->layer == nullptr) impl_->fail(errors);
  impl_->feature.reset(OGRFeature::CreateFeature(impl_->layer->GetLayerDefn()));
}

void TableFile::write(const std::vector<ColumnValue>& row, const std::optional<Geodetic>& place) {
  const gpkg::QuietErrors errors;
  OGRFeature& feature = *impl_->feature;
  feature.SetFID(OGRNullFID);
  for (std::size_t i = 0; i < row.size(); ++i) {
    gpkg::set_value(feature, static_cast<int>(i), row[i]);
  }
  if (feature.GetGeomFieldCount() > 0) gpkg::set_point(feature, place);
  if (impl_->layer->CreateFeature(&feature) != OGRERR_NONE) impl_->fail(errors);
}

void TableFile::finish() {
  const gpkg::QuietErrors errors;
  impl_->feature.reset();
  if (impl_->dataset->CommitTransaction() != OGRERR_NONE) impl_->fail(errors);
  impl_->dataset.reset();
  if (errors.has_failed() || std::rename(impl_->part.c_str(), impl_->file.c_str()) != 0) {
    throw OutputError(fmt::format("{}: {}", impl_->file, errors.message()));
  }
}

}  // namespace lsos
