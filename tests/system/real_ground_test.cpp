// A rover on real ground of the Moon's south polar region: its places and heights, compared with
// the raster, which the test reads and projects by other means.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "record/log.h"
#include "support/reference_data.h"
#include "system/plan_text.h"
#include "system/run_folder.h"

namespace lsos::test {
namespace {

constexpr double moon_radius_m = 1737400;

constexpr char raster_name[] = "dem/moon/nobile_rim2_ldem_6_cut_1m.tif";

// The raster is in the south polar stereographic projection of a sphere (Snyder 1987, eq. 21-1):
// x = 2 R tan(c/2) sin(lon), y = 2 R tan(c/2) cos(lon), c the angle from the pole.
std::string lon_lat(double x_m, double y_m) {
  const double c = 2 * std::atan(std::hypot(x_m, y_m) / (2 * moon_radius_m));
  return fmt::format("{:.9f},{:.9f}", std::atan2(x_m, y_m) * 180 / std::numbers::pi,
                     c * 180 / std::numbers::pi - 90);
}

class Raster {
 public:
  explicit Raster(const std::filesystem::path& file)
      : dataset_(GDALDataset::FromHandle(GDALOpen(file.c_str(), GA_ReadOnly))) {
    if (dataset_) dataset_->GetGeoTransform(transform_);
  }

  // Height by bilinear interpolation between cell centres.
  double height_m(const Geodetic& place) const {
    const double rho_m = 2 * moon_radius_m * std::tan((std::numbers::pi / 2 + place.lat_rad) / 2);
    const double column = (rho_m * std::sin(place.lon_rad) - transform_[0]) / transform_[1] - 0.5;
    const double row = (rho_m * std::cos(place.lon_rad) - transform_[3]) / transform_[5] - 0.5;
    const int i = static_cast<int>(column), j = static_cast<int>(row);
    double h[4];
    EXPECT_EQ(dataset_->GetRasterBand(1)->RasterIO(GF_Read, i, j, 2, 2, h, 2, 2, GDT_Float64, 0, 0),
              CE_None);
    const double u = column - i, v = row - j;
    return (1 - v) * ((1 - u) * h[0] + u * h[1]) + v * ((1 - u) * h[2] + u * h[3]);
  }

 private:
  GDALDatasetUniquePtr dataset_;
  double transform_[6] = {};
};

TEST(RealGround, is_driven_for_half_a_kilometre_at_the_height_of_the_raster) {
  LSOS_NEEDS_REFERENCE(raster_name);
  const TempFolder folder;
  const std::string track = lon_lat(158850, 95350) + " " + lon_lat(159000, 95200) + " " +
                            lon_lat(159200, 95150) + " " + lon_lat(159350, 94950) + " " +
                            lon_lat(159450, 94850);
  const std::string plan =
      folder.write("nobile.kml", kml({{"MissionInfo",
                                       {{"Planet", "Moon"},
                                        {"StartTime", "2026-01-01"},
                                        {"Terrain", reference_file(raster_name)}},
                                       ""},
                                      sev("A", lon_lat(158850, 95350)),
                                      event("Route", "A", 1, {{"Speed", "8 km/h"}}, line(track))}));
  const Outcome outcome = run({plan, "-o", folder / "run", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_GT(summary(folder / "run")["rovers"]["A"]["distance_m"], 500);

  GDALAllRegister();
  const Raster raster(reference_file(raster_name));
  double worst_m = 0, lowest_m = 1e9, highest_m = -1e9;
  for (const SampleRow& row : LogReader(folder / "run" / "log.gpkg").samples()) {
    worst_m = std::max(worst_m, std::abs(row.elevation_m - raster.height_m(row.place)));
    lowest_m = std::min(lowest_m, row.elevation_m);
    highest_m = std::max(highest_m, row.elevation_m);
    // The rover's reference point is within the springs' travel of the ground.
    EXPECT_NEAR(row.place.height_m, row.elevation_m, 0.3);
  }
  RecordProperty("worst_elevation_difference_m", std::to_string(worst_m));
  // Between cell centres a smooth surface differs from the bilinear one by curvature x 1 m^2 / 8.
  EXPECT_LT(worst_m, 0.05);
  EXPECT_GT(highest_m - lowest_m, 5);  // the ground is not flat
}

}  // namespace
}  // namespace lsos::test
