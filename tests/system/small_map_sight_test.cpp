// `lsos-host sight` on maps small enough for a line to each cell, compared with lines in the plane
// of their cells.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>

#include "support/reference_data.h"
#include "system/sight_map.h"

namespace lsos::test {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct Cell {
  int column, row;
};

struct CellHeights {
  std::vector<double> heights_m;
  int columns, rows;

  double at(double column, double row) const {
    const int u = std::clamp(static_cast<int>(column), 0, columns - 1);
    const int v = std::clamp(static_cast<int>(row), 0, rows - 1);
    return heights_m[static_cast<std::size_t>(v * columns + u)];
  }
};

struct SightQuery {
  Cell eye;
  double eye_m, target_m;
};

// Whether the line to a cell is above the ground wherever it crosses a row or column of cell
// centres. Missing cells hide nothing.
bool is_above(const CellHeights& ground, const SightQuery& query, const Cell& target) {
  const Cell& eye = query.eye;
  const double from_m = ground.at(eye.column, eye.row) + query.eye_m;
  const double to_m = ground.at(target.column, target.row) + query.target_m;
  const int across = target.column - eye.column, down = target.row - eye.row;
  for (const int count : {std::abs(across), std::abs(down)}) {
    for (int k = 1; k < count; ++k) {
      const double share = static_cast<double>(k) / count;
      const double u = eye.column + share * across, v = eye.row + share * down;
      // The ground is interpolated between two neighbouring cells of a column or a row.
      const double left = std::floor(u + 1e-9), above = std::floor(v + 1e-9);
      const double to_right = std::max(0.0, u - left), below = std::max(0.0, v - above);
      const double beside_m =
          to_right > below ? ground.at(left + 1, above) : ground.at(left, above + 1);
      const double to_beside = std::max(to_right, below);
      const double ground_m = to_beside < 1e-9
                                  ? ground.at(left, above)
                                  : (1 - to_beside) * ground.at(left, above) + to_beside * beside_m;
      if (ground_m > from_m + share * (to_m - from_m) + 1e-9) return false;
    }
  }
  return true;
}

struct Compared {
  int cells = 0, agreeing = 0, seen = 0;
};

Compared compared(const std::string& file, const SightQuery& query, bool is_flat,
                  const TempFolder& folder) {
  const Dataset dataset = opened(file);
  const CellHeights ground{samples(*dataset), dataset->GetRasterXSize(), dataset->GetRasterYSize()};
  const CellPlace eye = cell_place(*dataset, query.eye.column, query.eye.row);
  Words words{file,
              "--from",
              fmt::format("{},{}", eye.lon_lat, query.eye_m),
              "--height",
              fmt::format("{}", query.target_m),
              "-o",
              folder / "seen.tif"};
  if (is_flat) words.emplace_back("--flat");
  sight(words);
  const std::vector<double> ours = samples(*opened(folder / "seen.tif"));
  Compared counts;
  for (int row = 0; row < ground.rows; ++row) {
    for (int column = 0; column < ground.columns; ++column) {
      if (std::isnan(ground.at(column, row))) continue;
      const bool is_seen = is_above(ground, query, {column, row});
      const double value = ours[static_cast<std::size_t>(row * ground.columns + column)];
      ++counts.cells;
      counts.seen += is_seen ? 1 : 0;
      counts.agreeing += value == (is_seen ? 1 : 0) ? 1 : 0;
    }
  }
  return counts;
}

TEST(SmallMapSight, is_along_the_line_to_each_cell) {
  constexpr char rough[] = "dem/moon/gz_dem_moon_87p5N.tif";
  LSOS_NEEDS_REFERENCE(rough);
  const TempFolder folder;
  const std::string file = reference_file(rough);
  const Dataset dataset = opened(file);
  std::mt19937 random(5);
  Compared all;
  for (const double target_m : {0.0, 0.5, 2.0}) {
    const Cell eye{static_cast<int>(random() % static_cast<unsigned>(dataset->GetRasterXSize())),
                   static_cast<int>(random() % static_cast<unsigned>(dataset->GetRasterYSize()))};
    const Compared counts = compared(file, {eye, 1, target_m}, true, folder);
    all.cells += counts.cells;
    all.agreeing += counts.agreeing;
    all.seen += counts.seen;
  }
  std::printf("%d of %d cells alike, %d seen\n", all.agreeing, all.cells, all.seen);
  EXPECT_GE(all.agreeing, all.cells - 3) << "grazing lines may be rounded either way";
  EXPECT_LT(all.seen, all.cells);
}

// A generated map of 60 x 60 cells. Heights are in cell sides, so that all maps are equally steep.
struct GeneratedMap {
  const char* name;
  const char* crs;
  double west, north, cell;  // in the CRS's units
  double cell_m;
  std::function<double(int column, int row)> height_cells;
  SightQuery query;
  bool is_flat = true;
};

constexpr int side = 60;

std::string written(const GeneratedMap& generated, const TempFolder& folder) {
  GDALAllRegister();
  std::string file = folder / "made.tif";
  const Dataset dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file.c_str(), side, side, 1, GDT_Float32, nullptr));
  OGRSpatialReference crs;
  EXPECT_EQ(crs.SetFromUserInput(generated.crs), OGRERR_NONE);
  double transform[6] = {generated.west, generated.cell, 0, generated.north, 0, -generated.cell};
  dataset->SetGeoTransform(transform);
  dataset->SetSpatialRef(&crs);
  std::vector<double> heights_m;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column)
      heights_m.push_back(generated.cell_m * generated.height_cells(column, row));
  }
  EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, side, side, heights_m.data(), side,
                                                side, GDT_Float64, 0, 0),
            CE_None);
  return file;
}

class MadeMapSight : public ::testing::TestWithParam<GeneratedMap> {};

TEST_P(MadeMapSight, is_along_the_line_to_each_cell) {
  const TempFolder folder;
  const Compared counts =
      compared(written(GetParam(), folder), GetParam().query, GetParam().is_flat, folder);
  std::printf("%d of %d cells alike, %d seen\n", counts.agreeing, counts.cells, counts.seen);
  EXPECT_EQ(counts.agreeing, counts.cells);
}

double bowl(int column, int row) {
  const double u = column - 30, v = row - 30;
  return 0.02 * (u * u + v * v);
}
double hills(int column, int row) { return 3 * std::sin(0.7 * column) * std::cos(0.4 * row); }
double level(int, int) { return 0; }
double wall_across(int column, int) { return column == 20 ? 3 : 0; }
double wall_beside_hole(int column, int row) {
  if (row < 30 && (column == 29 || column == 31)) return missing;
  return row == 20 ? 3 : 0;
}

constexpr char moon_pole[] = "IAU_2015:30135", moon_degrees[] = "IAU_2015:30100";
constexpr char earth_utm[] = "EPSG:32610";
constexpr double degree_m = 1737400 * 3.14159265358979323846 / 180;

INSTANTIATE_TEST_SUITE_P(
    of, MadeMapSight,
    ::testing::Values(
        // Each cell is higher than all others on the line to it: its own height must not count.
        GeneratedMap{"a_bowl", moon_pole, 5000, 7000, 1, 1, bowl, {{30, 30}, 1, 0}},
        GeneratedMap{
            "a_bowl_of_small_cells", moon_pole, 5000, 7000, 0.25, 0.25, bowl, {{30, 30}, 1, 0}},
        GeneratedMap{"the_seam_of_longitudes",
                     moon_degrees,
                     179.97,
                     0.03,
                     0.001,
                     0.001 * degree_m,
                     hills,
                     {{5, 30}, 60, 1}},
        GeneratedMap{"a_wall_to_the_last_row",
                     earth_utm,
                     574000,
                     4141000,
                     1,
                     1,
                     wall_across,
                     {{5, 59}, 2, 0.5}},
        GeneratedMap{"a_wall_to_the_first_row",
                     earth_utm,
                     574000,
                     4141000,
                     1,
                     1,
                     wall_across,
                     {{40, 0}, 2, 0.5}},
        GeneratedMap{"a_wall_beside_a_hole",
                     moon_pole,
                     5000,
                     7000,
                     1,
                     1,
                     wall_beside_hole,
                     {{30, 40}, 2.1, 0.5}},
        GeneratedMap{"an_eye_between_two_holes",
                     moon_pole,
                     5000,
                     7000,
                     1,
                     1,
                     wall_beside_hole,
                     {{30, 25}, 1.1, 0.5}},
        GeneratedMap{"an_eye_left_of_a_hole",
                     moon_pole,
                     5000,
                     7000,
                     1,
                     1,
                     wall_beside_hole,
                     {{28, 2}, 1.1, 0.5}},
        GeneratedMap{"an_eye_right_of_a_hole_in_degrees",
                     moon_degrees,
                     10,
                     1,
                     0.001,
                     0.001 * degree_m,
                     wall_beside_hole,
                     {{30, 5}, 30, 15}},
        GeneratedMap{"cells_of_5_cm",
                     earth_utm,
                     574000,
                     4141000,
                     0.05,
                     0.05,
                     wall_across,
                     {{5, 30}, 0.1, 0.02}},
        GeneratedMap{"the_eye_itself",
                     moon_degrees,
                     10,
                     1,
                     1.0 / 32768,
                     degree_m / 32768,
                     level,
                     {{30, 30}, 2, 2},
                     false}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace lsos::test
