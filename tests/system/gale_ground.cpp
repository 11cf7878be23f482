#include "system/gale_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "support/reference_data.h"
#include "system/run_folder.h"

namespace lsos::test {

namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

std::array<double, 4> weights(double t) {
  return {t * (-1 + t * (2 - t)) / 2, (2 + t * t * (-5 + 3 * t)) / 2, t * (1 + t * (4 - 3 * t)) / 2,
          t * t * (t - 1) / 2};
}

}  // namespace

std::vector<TraverseRow> curiosity_traverse() {
  std::istringstream text(read_text(reference_file(gale_traverse)));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> names = cells(line);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  std::vector<TraverseRow> rows;
  while (std::getline(text, line)) {
    const std::vector<std::string> row = cells(line);
    const auto number = [&](const char* name) { return std::stod(row.at(column(name))); };
    TraverseRow stand;
    stand.sol = static_cast<int>(number("sol"));
    stand.easting_m = number("easting_m");
    stand.northing_m = number("northing_m");
    stand.elevation_m = number("elev_m");
    stand.yaw_rad = number("yaw_rad");
    stand.lon_as_written_deg = number("lon_dd");
    stand.lat_as_written_deg = number("lat_dd");
    stand.driven_m = number("mobtrav_id");
    rows.push_back(stand);
  }
  return rows;
}

GaleRaster::GaleRaster(const std::filesystem::path& file) {
  GDALAllRegister();
  dataset_.reset(GDALDataset::FromHandle(GDALOpen(file.c_str(), GA_ReadOnly)));
  if (dataset_) dataset_->GetGeoTransform(transform_);
}

bool GaleRaster::holds(const Localisation& stand) const {
  const double u = column(stand.easting_m), v = row(stand.northing_m);
  return u > 4 && v > 4 && u < dataset_->GetRasterXSize() - 5 && v < dataset_->GetRasterYSize() - 5;
}

double GaleRaster::height_m(double easting_m, double northing_m) const {
  const double u = column(easting_m), v = row(northing_m);
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  double h[16];
  EXPECT_EQ(
      dataset_->GetRasterBand(1)->RasterIO(GF_Read, i - 1, j - 1, 4, 4, h, 4, 4, GDT_Float64, 0, 0),
      CE_None);
  const std::array<double, 4> across = weights(u - i), down = weights(v - j);
  double sum_m = 0;
  for (int k = 0; k < 16; ++k) sum_m += down[k / 4] * across[k % 4] * h[k];
  return sum_m;
}

double GaleRaster::column(double easting_m) const {
  return (easting_m - transform_[0]) / transform_[1] - 0.5;
}

double GaleRaster::row(double northing_m) const {
  return (northing_m - transform_[3]) / transform_[5] - 0.5;
}

}  // namespace lsos::test
