// A thin wrapper of GDAL's vector API to write one GeoPackage: ownership, and errors as text
// instead of printed. Only for use in this folder.
#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "record/layers.h"

namespace lsos::gpkg {

// While an object exists, GDAL's errors of this thread are kept in it and not printed.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

  bool has_failed() const { return !message_.empty(); }
  // The first failure, or a general message if there was none.
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

// Creates a file in WAL mode; nullptr when that fails (`file` exists, no space).
Dataset create(const std::string& file);
// The same without write-ahead logging, also in GDAL's memory: what is written there is read only
// once it is whole.
Dataset create_at(const std::string& file);
// To write more into a log, in WAL mode; nullptr when the file is no GeoPackage.
Dataset open_to_write(const std::string& file);

// Says that the file, with what is not folded into it yet, takes more than so many bytes; "" where
// it does not, or `bytes_max` is 0.
std::string size_fault(const std::string& file, std::uintmax_t bytes_max);

// nullptr on failure.
OGRLayer* create_layer(GDALDataset& dataset, const LayerSpec& spec, OGRSpatialReference& crs);

// A text as it stands in a statement.
std::string quoted(const std::string& text);

// Runs one statement and passes each row of its result to `visit`. Errors are reported by a
// QuietErrors around the call.
void run_sql(GDALDataset& dataset, const std::string& statement,
             const std::function<void(const OGRFeature&)>& visit = {});

// Writes titles and meanings of the columns of all layers in the form of the GeoPackage's schema
// extension.
void add_titles(GDALDataset& dataset);

// In a field of date and time the value is a text like "2026-07-01T00:00:00.000Z".
void set_value(OGRFeature& feature, int field, const ColumnValue& value);

// No point where there is no place, or numbers that are none.
void set_point(OGRFeature& feature, const std::optional<Geodetic>& place);
void set_line(OGRFeature& feature, const std::vector<Geodetic>& line);

}  // namespace lsos::gpkg
