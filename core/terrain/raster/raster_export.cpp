#include "terrain/raster/raster_export.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "access/gdal_access.h"
#include "access/memory_file.h"
#include "base/files.h"
#include "base/output_error.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

[[noreturn]] void refuse_to_write(const std::string& file) {
  const std::string why = GdalSilence::message();
  throw OutputError(fmt::format("{}: cannot be written: {}", file, why.empty() ? "no space" : why));
}

GDALDriver& driver(const char* name) {
  register_drivers();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(name);
  if (found == nullptr) {
    throw InputError({}, fmt::format("this GDAL has no driver {}; 3.1 or newer has it", name));
  }
  return *found;
}

GDALDatasetUniquePtr in_memory(const MapGrid& grid, const Body& body,
                               const std::vector<MapBand>& bands, const MapRow& values) {
  const int count = static_cast<int>(bands.size());
  GDALDatasetUniquePtr dataset(
      driver("MEM").Create("", grid.columns, grid.rows, count, GDT_Float32, nullptr));
  if (!dataset) refuse_to_write("the map");
  OGRSpatialReference crs;
  if (crs.importFromWkt(grid.crs.c_str()) != OGRERR_NONE) {
    throw InputError({}, "the map has no coordinate reference system that GDAL reads");
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  dataset->SetSpatialRef(&crs);
  dataset->SetGeoTransform(const_cast<double*>(grid.geotransform.data()));
  for (int k = 0; k < count; ++k) {
    GDALRasterBand& band = *dataset->GetRasterBand(k + 1);
    band.SetNoDataValue(std::numeric_limits<float>::quiet_NaN());
    band.SetUnitType(bands[static_cast<std::size_t>(k)].unit.c_str());
    band.SetDescription(bands[static_cast<std::size_t>(k)].name.c_str());
  }
  const RasterMap map = grid.map(body);
  std::vector<std::optional<Geodetic>> places(grid.columns);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      places[column] = map.place({static_cast<double>(column), static_cast<double>(row)});
    }
    const std::vector<double> found = values(places);
    const std::vector<float> lines(found.begin(), found.end());
    for (int k = 0; k < count; ++k) {
      auto* line = const_cast<float*>(&lines[static_cast<std::size_t>(k) * places.size()]);
      if (dataset->GetRasterBand(k + 1)->RasterIO(GF_Write, 0, row, grid.columns, 1, line,
                                                  grid.columns, 1, GDT_Float32, 0, 0,
                                                  nullptr) != CE_None) {
        refuse_to_write("the map");
      }
    }
  }
  return dataset;
}

// Length of the map's unit, or of a degree where the map is geographic, m.
double crs_unit_m(const OGRSpatialReference& crs, const Body& body) {
  if (crs.IsGeographic()) return body.equatorial_radius_m * std::numbers::pi / 180;
  return crs.GetLinearUnits();
}

// Hillshade by gdaldem, which takes the map's unit for a metre unless a scale is given.
GDALDatasetUniquePtr hillshade(GDALDataset& heights, const Body& body) {
  CPLStringList words;
  for (const char* word : {"-of", "MEM", "-compute_edges"}) words.AddString(word);
  if (const double to_m = crs_unit_m(*heights.GetSpatialRef(), body); to_m != 1) {
    words.AddString("-s");
    words.AddString(fmt::format("{}", to_m).c_str());
  }
  const std::unique_ptr<GDALDEMProcessingOptions, void (*)(GDALDEMProcessingOptions*)> options(
      GDALDEMProcessingOptionsNew(words.List(), nullptr), GDALDEMProcessingOptionsFree);
  int misused = FALSE;
  GDALDatasetUniquePtr shade(GDALDataset::FromHandle(GDALDEMProcessing(
      "", GDALDataset::ToHandle(&heights), "hillshade", nullptr, options.get(), &misused)));
  if (!shade) refuse_to_write("the hillshade");
  shade->GetRasterBand(1)->SetDescription("hillshade");
  return shade;
}

void write_cog(GDALDataset& dataset, const std::string& file) {
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "YES");
  options.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
  const MemoryFile made("map.tif");
  CPLErrorReset();
  GDALDatasetUniquePtr copy(driver("COG").CreateCopy(made.name().c_str(), &dataset, FALSE,
                                                     options.List(), nullptr, nullptr));
  const bool is_made = copy != nullptr;
  copy.reset();
  if (!is_made || CPLGetLastErrorType() >= CE_Failure) refuse_to_write(file);
  write_file(file, made.bytes());
}

}  // namespace

void write_map(const std::string& file, const MapGrid& grid, const Body& body,
               const std::vector<MapBand>& bands, const MapRow& values) {
  const GDALDatasetUniquePtr dataset = in_memory(grid, body, bands, values);
  const GdalSilence silence;
  write_cog(*dataset, file);
}

void write_raster(const RasterExport& to, const MapGrid& grid, const Body& body,
                  const std::function<double(const Geodetic&)>& height_m) {
  const MapRow heights_m = [&](std::span<const std::optional<Geodetic>> places) {
    std::vector<double> values;
    for (const auto& place : places) {
      values.push_back(place ? height_m(*place) : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
  };
  GDALDatasetUniquePtr dataset = in_memory(grid, body, {{"height", "m"}}, heights_m);
  const GdalSilence silence;
  if (to.is_hillshade) dataset = hillshade(*dataset, body);
  write_cog(*dataset, to.file);
}

}  // namespace lsos
