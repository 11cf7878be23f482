// A thin skin over GDAL's vector API for one GeoPackage: ownership, and errors that come as text
// instead of being printed. Only for this folder.
#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <functional>
#include <memory>
#include <string>

#include "record/layers.h"

namespace lsos::gpkg {

// While it lives, GDAL's errors of this thread are kept here and printed nowhere.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

  bool has_failed() const { return !message_.empty(); }
  // The first failure, else a general word.
  std::string message() const;

 private:
  static void handle(CPLErr severity, CPLErrorNum number, const char* text);

  std::string message_;
};

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;
using Feature = std::unique_ptr<OGRFeature>;

// A new file in WAL mode; nullptr when it cannot be made (`file` exists, no space).
Dataset create(const std::string& file);
// nullptr when it is no GeoPackage.
Dataset open_to_read(const std::string& file);

// nullptr when it fails.
OGRLayer* create_layer(GDALDataset& dataset, const LayerSpec& spec, OGRSpatialReference& crs);

// Runs one statement and gives each row of its answer to `visit`. What fails, a QuietErrors around
// the call knows.
void run_sql(GDALDataset& dataset, const std::string& statement,
             const std::function<void(const OGRFeature&)>& visit = {});

// Titles and meanings of the columns of all layers, as the GeoPackage's schema extension has them.
void add_titles(GDALDataset& dataset);

// A text as "2026-07-01T00:00:00.000Z" goes into a field of date and time.
void set_value(OGRFeature& feature, int field, const ColumnValue& value);
ColumnValue value(const OGRFeature& feature, int field, ColumnType type);

void set_point(OGRFeature& feature, const std::optional<Geodetic>& place);
std::optional<Geodetic> point(const OGRFeature& feature);

void set_line(OGRFeature& feature, const std::vector<Geodetic>& line);
std::vector<Geodetic> line(const OGRFeature& feature);

}  // namespace lsos::gpkg
