// Heights, slopes and aspects as GDAL's own tools compute them.
#include "terrain/raster/raster_reader.h"

#include <cmath>
#include <map>
#include <sstream>

#include "ground_fixture.h"

namespace lsos {
namespace {

constexpr double deg = M_PI / 180;

// Rows of a file of reference data by column name, grouped by raster.
using Row = std::map<std::string, std::string>;
std::map<std::string, std::vector<Row>> rows_by_raster(const std::string& file) {
  std::map<std::string, std::vector<Row>> rows;
  std::ifstream in(file);
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = split(line);
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split(line);
    Row row;
    for (std::size_t i = 0; i < cells.size(); ++i) row[names[i]] = cells[i];
    rows[row["file"]].push_back(row);
  }
  return rows;
}

double number(const Row& row, const std::string& name, double otherwise = NAN) {
  const auto cell = row.find(name);
  return cell == row.end() || cell->second.empty() ? otherwise : std::stod(cell->second);
}

TEST(RasterReader, agrees_with_gdal_at_every_truth_point) {
  LSOS_NEEDS_REFERENCE("dem/gdal_truth_points.csv");
  const std::string file = reference_file("dem/gdal_truth_points.csv");
  int points = 0;
  for (const auto& [raster, rows] : rows_by_raster(file)) {
    const RasterReader reader({reference_file(raster)}, {});
    const double radius_m = reader.own_body().equatorial_radius_m;
    double worst_m = 0, worst_deg = 0;
    for (const Row& row : rows) {
      ++points;
      const Geodetic place = geodetic_from_degrees(number(row, "lonE_deg"), number(row, "lat_deg"));
      const auto found = reader.at(place);
      ASSERT_TRUE(found) << raster;
      const double off_m =
          std::hypot(found->map.x - number(row, "x_crs"), found->map.y - number(row, "y_crs"));
      worst_deg = std::max(worst_deg, off_m / radius_m / deg);
      const double bilinear = number(row, "value_bilinear_raw");
      ASSERT_EQ(found->height_m.has_value(), !std::isnan(bilinear)) << raster;
      if (!found->height_m) continue;
      double expected_m = bilinear * number(row, "band_scale", 1) + number(row, "band_offset", 0);
      if (is_radius_of(reader.own_body(), expected_m)) expected_m -= radius_m;
      worst_m = std::max(worst_m, std::abs(*found->height_m - expected_m));
    }
    EXPECT_LT(worst_deg, 1e-6) << raster;
    EXPECT_LT(worst_m, 1e-3) << raster;
    std::printf("%-55s %2zu points: %.1e deg, %.1e m at most\n", raster.c_str(), rows.size(),
                worst_deg, worst_m);
  }
  EXPECT_GT(points, 80);
}

TEST(RasterReader, agrees_with_gdaldem_at_every_truth_cell) {
  LSOS_NEEDS_REFERENCE("dem/gdaldem_truth.csv");
  const std::string file = reference_file("dem/gdaldem_truth.csv");
  int cells = 0;
  for (const auto& [raster, rows] : rows_by_raster(file)) {
    const RasterReader reader({reference_file(raster)}, {});
    double worst_slope_deg = 0, worst_aspect_deg = 0;
    for (const Row& row : rows) {
      ++cells;
      const auto place = reader.raster().map().place({number(row, "pixel"), number(row, "line")});
      ASSERT_TRUE(place);
      const auto found = reader.at(*place);
      ASSERT_TRUE(found && found->slope_rad && found->aspect_grid_rad);
      worst_slope_deg = std::max(worst_slope_deg,
                                 std::abs(*found->slope_rad / deg - number(row, "slope_horn_deg")));
      worst_aspect_deg = std::max(
          worst_aspect_deg,
          std::abs(std::remainder(
              *found->aspect_grid_rad / deg - number(row, "aspect_deg_cw_from_gridN"), 360)));
    }
    EXPECT_LT(worst_slope_deg, 0.05) << raster;
    EXPECT_LT(worst_aspect_deg, 0.05) << raster;
    std::printf("%-55s %2zu cells: slope %.1e, aspect %.1e deg at most\n", raster.c_str(),
                rows.size(), worst_slope_deg, worst_aspect_deg);
  }
  EXPECT_EQ(cells, 40);
}

RasterReader reader_of(const std::string& crs, const std::string& geotransform,
                       const std::vector<std::vector<double>>& rows) {
  return RasterReader({TextRaster{crs, geotransform, "", rows}.write("r")}, {});
}

TEST(RasterReader, turns_aspects_from_the_map_to_true_north) {
  // The ground falls along -y on a south polar map: at longitude L true north is turned clockwise
  // by L from the map's y axis, so that -y is 180 degrees less L.
  const auto rows = rows_of(20, 20, [](int, int row) { return 100 - 0.125 * row; });
  const RasterReader reader = reader_of("IAU_2015:30135", "99990, 1, 0, 100010, 0, -1", rows);
  const auto place = reader.raster().map().place({10, 10});
  ASSERT_TRUE(place);
  EXPECT_NEAR(lon_deg(*place), 45, 1e-2);
  const auto found = reader.at(*place);
  EXPECT_NEAR(*found->slope_rad, std::atan(0.125), 1e-9);
  EXPECT_NEAR(*found->aspect_grid_rad / deg, 180, 1e-9);
  EXPECT_NEAR(*found->aspect_rad / deg, 180 - lon_deg(*place), 1e-6);
  EXPECT_EQ(reader.crs_unit(), "m");
}

TEST(RasterReader, measures_cells_in_degrees_on_the_ground) {
  // At 60 degrees of latitude a degree of longitude is half as long. The ground falls east by 1 m
  // per cell of 0.001 degrees: 15.16 m.
  const auto rows = rows_of(20, 20, [](int column, int) { return 100.0 - column; });
  const RasterReader reader =
      reader_of("IAU_2015:30100", "-0.01, 0.001, 0, 60.0105, 0, -0.001", rows);
  const auto found = reader.at(*reader.raster().map().place({10, 10}));
  EXPECT_NEAR(*found->slope_rad, std::atan(1 / (0.001 * deg * 1737400 * 0.5)), 1e-6);
  EXPECT_NEAR(*found->aspect_rad / deg, 90, 1e-9);
  EXPECT_EQ(reader.crs_unit(), "deg");
}

TEST(RasterReader, knows_cells_that_are_not_square_and_maps_in_feet) {
  const auto rows = rows_of(20, 20, [](int column, int row) { return 100.0 - column - 2.0 * row; });
  const RasterReader reader = reader_of("+proj=tmerc +lat_0=40 +lon_0=-100 +datum=WGS84 +units=ft",
                                        "-50, 5, 0, 100, 0, -10", rows);
  const auto found = reader.at(*reader.raster().map().place({10, 10}));
  const double rise = 1 / (5 * 0.3048);  // the same along both axes
  EXPECT_NEAR(*found->slope_rad, std::atan(std::sqrt(2) * rise), 1e-9);
  EXPECT_NEAR(*found->aspect_grid_rad / deg, 135, 1e-9);
  EXPECT_EQ(reader.own_body().name, "Earth");
  EXPECT_EQ(reader.crs_unit(), "foot");
}

TEST(RasterReader, answers_nothing_beyond_the_raster_and_beside_what_is_missing) {
  auto rows = rows_of(20, 20, [](int column, int row) { return 2.0 * column + row; });
  rows[5][5] = NAN;
  const RasterReader reader =
      reader_of("+proj=laea +lat_0=0 +lon_0=0 +R=1737400", "-10, 1, 0, 10, 0, -1", rows);
  const auto at = [&](double u, double v) {
    return reader.at(*reader.raster().map().place({u, v})).value();
  };
  EXPECT_FALSE(at(5, 5).height_m);
  EXPECT_FALSE(at(5.3, 5.3).height_m);
  EXPECT_TRUE(at(6, 5).height_m);  // its own centre
  EXPECT_FALSE(at(6, 5).slope_rad);
  EXPECT_FALSE(at(0, 10).slope_rad);
  EXPECT_NEAR(*at(-0.4, 10).height_m, 10, 1e-9);
  EXPECT_FALSE(at(-0.6, 10).height_m);
  EXPECT_NEAR(at(-0.6, 10).map.x, -10.1, 1e-6);
}

TEST(RasterReader, goes_on_across_the_seam_of_a_raster_around_the_body) {
  const auto rows = rows_of(36, 18, [](int column, int row) {
    return 1000 * std::cos((column + 0.5) * 10 * deg) + 10 * row;
  });
  const RasterReader reader = reader_of("IAU_2015:30100", "-180, 10, 0, 90, 0, -10", rows);
  // The point lies between the last column and the first.
  EXPECT_NEAR(*reader.at(geodetic_from_degrees(180, 5))->height_m,
              1000 * std::cos(5 * deg) + 10 * 8, 1e-6);
  EXPECT_NEAR(*reader.at(geodetic_from_degrees(177, 5))->height_m,
              reader.at(geodetic_from_degrees(-177, 5))->height_m.value(), 1e-6);
  EXPECT_TRUE(reader.at(geodetic_from_degrees(-175, 5))->slope_rad);
}

TEST(RasterReader, names_bodies_that_we_do_not_drive_on) {
  LSOS_NEEDS_REFERENCE("dem/mars/Phobos_ME_HRSC_DEM_Global_2ppd.tiff");
  const std::string file = reference_file("dem/mars/Phobos_ME_HRSC_DEM_Global_2ppd.tiff");
  const RasterReader reader({file}, {});
  EXPECT_EQ(reader.own_body().name, "Phobos");
  EXPECT_EQ(reader.own_body().equatorial_radius_m, 11100);
}

}  // namespace
}  // namespace lsos
