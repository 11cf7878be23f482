#include "interchange/table_writer.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <memory>

#include "access/gdal_access.h"
#include "access/memory_file.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/output_error.h"
#include "interchange/cell_text.h"
#include "interchange/places.h"
#include "interchange/workbook_style.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

constexpr std::size_t cell_bytes_max = 32767;  // of XLSX

const char* driver_of(const std::string& ending) {
  if (ending == ".csv") return "CSV";
  if (ending == ".xlsx") return "XLSX";
  if (ending == ".ods") return "ODS";
  return ending == ".gpkg" ? "GPKG" : "GeoJSON";
}

bool is_spreadsheet(const std::string& ending) {
  return ending == ".csv" || ending == ".xlsx" || ending == ".ods";
}

// Whether the text is the shortest form of a number that survives a spreadsheet.
template <typename T>
bool is_shortest(const std::string& text) {
  constexpr std::size_t digits_max = 12;
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && text.size() <= digits_max &&
         fmt::format("{}", value) == text;
}

// Whether the text is a decimal whose value survives a spreadsheet: one of 15 digits at most.
bool is_decimal(const std::string& text) {
  constexpr std::ptrdiff_t digits_max = 15;
  const auto digits = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
  const bool has_others = text.find_first_not_of("0123456789.-") != std::string::npos;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !has_others && error == std::errc() && end == text.data() + text.size() &&
         digits <= digits_max;
}

OGRFieldType type_of(const Table& table, std::size_t column, bool is_workbook) {
  const bool counts_value = is_workbook && table.numbers.contains(column);
  bool is_integer = true, is_real = true;
  for (const TableRow& row : table.rows) {
    const std::string text = cell(row, column);
    if (text.empty()) continue;
    is_integer = is_integer && is_shortest<std::int64_t>(text);
    is_real = is_real && (is_shortest<double>(text) || (counts_value && is_decimal(text)));
  }
  return is_integer ? OFTInteger64 : is_real ? OFTReal : OFTString;
}

OGRwkbGeometryType geometry_of(const Table& table) {
  OGRwkbGeometryType type = wkbNone;
  for (const TableRow& row : table.rows) {
    if (!row.geometry) continue;
    const OGRwkbGeometryType own = row.geometry->kind == "Point"        ? wkbPoint
                                   : row.geometry->kind == "LineString" ? wkbLineString
                                                                        : wkbPolygon;
    type = type == wkbNone || type == own ? own : wkbUnknown;
  }
  return type;
}

class TableWriter {
 public:
  TableWriter(const std::string& ending, const Body& body, const std::string& file)
      : ending_(ending), file_(file), made_("plan" + ending) {
    crs_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (crs_.SetFromUserInput(std::string(body.crs).c_str()) != OGRERR_NONE) {
      refuse("PROJ does not know " + std::string(body.crs));
    }
  }

  std::string write(const std::vector<Table>& tables) {
    register_drivers();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_of(ending_));
    if (driver == nullptr) refuse(fmt::format("GDAL has no driver {}", driver_of(ending_)));
    Dataset dataset(driver->Create(made_.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (dataset == nullptr) refuse(GdalSilence::message());
    for (const Table& table : tables) add(table, *dataset);
    dataset.reset();
    const std::string_view bytes = made_.bytes();
    if (bytes.empty()) refuse(GdalSilence::message());
    std::string file(bytes);
    return ending_ == ".xlsx" ? styled_workbook(file, tables) : file;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw OutputError(fmt::format("{}: cannot be written: {}", file_, why));
  }

  void add(const Table& table, GDALDataset& dataset) {
    CPLStringList options;
    if (ending_ == ".geojson") options.SetNameValue("COORDINATE_PRECISION", "12");
    if (ending_ == ".csv") options.SetNameValue("STRING_QUOTING", "IF_NEEDED");
    if (ending_ == ".gpkg") options.SetNameValue("GEOMETRY_NAME", "geom");
    const OGRwkbGeometryType kind = is_spreadsheet(ending_) ? wkbNone : geometry_of(table);
    // GeoJSON is degrees of no stated body: one in its own CRS is refused by most viewers.
    OGRSpatialReference* crs = ending_ == ".gpkg" && kind != wkbNone ? &crs_ : nullptr;
    OGRLayer* layer = dataset.CreateLayer(table.name.c_str(), crs, kind, options.List());
    if (layer == nullptr) refuse(GdalSilence::message());
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      const bool is_workbook = ending_ == ".xlsx" || ending_ == ".ods";
      OGRFieldDefn field(table.header[i].c_str(), type_of(table, i, is_workbook));
      if (layer->CreateField(&field) != OGRERR_NONE) refuse(GdalSilence::message());
    }
    for (const TableRow& row : table.rows) add(row, table, *layer);
  }

  void add(const TableRow& row, const Table& table, OGRLayer& layer) {
    const std::unique_ptr<OGRFeature> feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      const std::string text = cell(row, i);
      if (text.empty()) continue;
      if (text.size() > cell_bytes_max && ending_ == ".xlsx") {
        throw InputError({file_, 0},
                         fmt::format("{} of row {} has {} characters, a cell of a .xlsx "
                                     "file at most {}; .ods, .csv, .gpkg and .geojson "
                                     "have room for it",
                                     table.header[i], row.number + 1, text.size(), cell_bytes_max));
      }
      const bool is_text =
          layer.GetLayerDefn()->GetFieldDefn(static_cast<int>(i))->GetType() == OFTString;
      feature->SetField(static_cast<int>(i), (is_text ? guarded(text) : text).c_str());
    }
    if (row.geometry) {
      const std::string wkt = wkt_of(*row.geometry);
      OGRGeometry* geometry = nullptr;
      if (OGRGeometryFactory::createFromWkt(wkt.c_str(), nullptr, &geometry) != OGRERR_NONE) {
        refuse(GdalSilence::message());
      }
      feature->SetGeometryDirectly(geometry);
    }
    if (layer.CreateFeature(feature.get()) != OGRERR_NONE) refuse(GdalSilence::message());
  }

  // The text as the format has it, so that no spreadsheet takes it for a formula.
  std::string guarded(const std::string& text) const {
    if (ending_ == ".csv") return guarded_text(text);
    return ending_ == ".ods" ? guarded_in_ods(text) : text;
  }

  std::string ending_, file_;
  MemoryFile made_;
  OGRSpatialReference crs_;
};

}  // namespace

std::string tables_as(const std::string& ending, const std::vector<Table>& tables, const Body& body,
                      const std::string& file) {
  const GdalSilence silence;
  return TableWriter(ending, body, file).write(tables);
}

}  // namespace lsos
