// Calls `lsos-host sight` and reads rasters cell by cell.
#pragma once

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {

inline nlohmann::json sight(const Words& arguments) {
  Words words{"sight"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.exit_code == 0 ? nlohmann::json::parse(outcome.out)
                                : nlohmann::json::array({nlohmann::json::object()});
}

using Dataset = GDALDatasetUniquePtr;

inline Dataset opened(const std::string& file) {
  GDALAllRegister();
  CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");  // writes no .aux.xml beside the data
  return Dataset(GDALDataset::FromHandle(GDALOpen(file.c_str(), GA_ReadOnly)));
}

inline std::vector<double> samples(GDALDataset& dataset) {
  const int columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
  std::vector<double> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  EXPECT_EQ(dataset.GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns,
                                               rows, GDT_Float64, 0, 0),
            CE_None);
  return values;
}

// The centre of a cell in map coordinates, and as "lon,lat" in degrees.
struct CellPlace {
  double x = 0, y = 0;
  std::string lon_lat;
};

inline CellPlace cell_place(GDALDataset& dataset, int column, int row) {
  double transform[6];
  dataset.GetGeoTransform(transform);
  const double x = transform[0] + (column + 0.5) * transform[1];
  const double y = transform[3] + (row + 0.5) * transform[5];
  std::unique_ptr<OGRSpatialReference> crs(dataset.GetSpatialRef()->Clone());
  std::unique_ptr<OGRSpatialReference> geographic(crs->CloneGeogCS());
  crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  geographic->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(crs.get(), geographic.get()));
  double lon_deg = x, lat_deg = y;
  EXPECT_TRUE(transformation->Transform(1, &lon_deg, &lat_deg));
  return {x, y, fmt::format("{:.12f},{:.12f}", lon_deg, lat_deg)};
}

}  // namespace lsos::test
