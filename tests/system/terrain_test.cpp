// `lsos-host terrain` as an engineer uses it, and its exported maps compared with GDAL.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/reference_data.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

constexpr double pi = 3.14159265358979323846;

json terrain(const Words& arguments, const Surroundings& where = {}) {
  Words words{"terrain"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome outcome = run(words, where);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.exit_code == 0 ? json::parse(outcome.out) : json::array({json::object()});
}

// A map, read by GDAL.
class Map {
 public:
  explicit Map(const fs::path& file) {
    GDALAllRegister();
    dataset_.reset(GDALDataset::FromHandle(GDALOpen(file.c_str(), GA_ReadOnly)));
    EXPECT_TRUE(dataset_) << file;
    if (!dataset_) return;
    dataset_->GetGeoTransform(transform_);
    const OGRSpatialReference* crs = dataset_->GetSpatialRef();
    std::unique_ptr<OGRSpatialReference> geographic(crs->CloneGeogCS());
    geographic->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to_geographic_.reset(OGRCreateCoordinateTransformation(crs, geographic.get()));
  }

  GDALDataset& dataset() { return *dataset_; }
  std::string place(int column, int row) const {
    double x = transform_[0] + (column + 0.5) * transform_[1];
    double y = transform_[3] + (row + 0.5) * transform_[5];
    EXPECT_TRUE(to_geographic_->Transform(1, &x, &y));
    return fmt::format("{:.12f},{:.12f}", x, y);
  }
  double value(int column, int row) {
    double value = 0;
    EXPECT_EQ(dataset_->GetRasterBand(1)->RasterIO(GF_Read, column, row, 1, 1, &value, 1, 1,
                                                   GDT_Float64, 0, 0),
              CE_None);
    return value;
  }

 private:
  GDALDatasetUniquePtr dataset_;
  std::unique_ptr<OGRCoordinateTransformation> to_geographic_;
  double transform_[6] = {};
};

// Compares heights at 12 cells with those of the program at the same places. Samples have 32 bits
// and so hold a height to 1e-7 of its value.
void expect_agreement(Map& map, Words question, double tolerance_m) {
  std::vector<double> expected_m;
  const int columns = map.dataset().GetRasterXSize(), rows = map.dataset().GetRasterYSize();
  for (int k = 0; k < 12; ++k) {
    const int column = (7 + k * 37) % columns;
    const int row = (5 + k * 53) % rows;
    question.insert(question.end(), {"--at", map.place(column, row)});
    expected_m.push_back(map.value(column, row));
  }
  const json points = terrain(question);
  ASSERT_EQ(points.size(), expected_m.size());
  int found = 0;
  for (std::size_t k = 0; k < expected_m.size(); ++k) {
    if (points[k]["height_m"].is_null()) {
      EXPECT_TRUE(std::isnan(expected_m[k]));
      continue;
    }
    ++found;
    EXPECT_NEAR(points[k]["height_m"].get<double>(), expected_m[k], tolerance_m) << points[k];
  }
  EXPECT_GT(found, 5);
}

TEST(Terrain, answers_with_the_fields_of_the_contract) {
  const json points = terrain({"Slope", "--at", "30,60", "--at", "30.01,60.01"});
  ASSERT_EQ(points.size(), 2u);
  for (const char* key : {"raster_height_m", "slope_deg", "aspect_deg", "aspect_grid_deg"}) {
    EXPECT_TRUE(points[0].contains(key) && points[0][key].is_null()) << key;
  }
  EXPECT_EQ(points[0]["body"], "Moon");
  EXPECT_EQ(points[0]["crs_unit"], "m");
  EXPECT_EQ(points[0]["lon_deg"], 30);
  EXPECT_EQ(points[0]["lat_deg"], 60);
  EXPECT_NEAR(points[0]["x"].get<double>(), 0, 1e-6);
  // The site is the first point, where the ground rises to the south by 10 degrees.
  EXPECT_NEAR(points[0]["surface_slope_deg"].get<double>(), 10, 1e-6);
  EXPECT_NEAR(points[0]["normal"][1].get<double>(), std::sin(10 * pi / 180), 1e-9);
  EXPECT_NEAR(points[1]["x"].get<double>(), 0.01 * pi / 180 * 1737400 * std::cos(60.01 * pi / 180),
              1);
  EXPECT_LT(points[1]["height_m"], -50);
  EXPECT_EQ(terrain({"Flat", "--planet", "Mars", "--at", "0,0"})[0]["body"], "Mars");
}

TEST(Terrain, of_a_raster_is_what_stands_in_it) {
  LSOS_NEEDS_REFERENCE("dem/moon/nobile_rim2_ldem_6_cut_1m.tif");
  const std::string file = reference_file("dem/moon/nobile_rim2_ldem_6_cut_1m.tif");
  // The values are a row of gdal_truth_points.csv, at a cell's centre.
  const json point = terrain({file, "--at", "58.962023979,-83.897678800"})[0];
  EXPECT_NEAR(point["raster_height_m"].get<double>(), 1008.5296, 1e-3);
  EXPECT_NEAR(point["height_m"].get<double>(), 1008.5296, 1e-3);
  EXPECT_NEAR(point["x"].get<double>(), 158699.5, 1e-3);
  EXPECT_NEAR(point["y"].get<double>(), 95499.5, 1e-3);
  EXPECT_TRUE(point["slope_deg"].is_null());  // at the edge
  EXPECT_TRUE(terrain({file, "--at", "0,0"})[0]["height_m"].is_null());
}

TEST(Terrain, reads_a_raster_inside_an_archive) {
  LSOS_NEEDS_REFERENCE("dem/formats/N10W110.hgt.zip");
  const std::string file = reference_file("dem/formats/N10W110.hgt.zip");
  const json points =
      terrain({"/vsizip/" + file + "/N10W110.hgt", "--at", "-109.5,10.5", "--at", "-120,0"});
  EXPECT_EQ(points[0]["raster_height_m"], 0);
  EXPECT_EQ(points[0]["height_m"], 0);
  EXPECT_EQ(points[0]["body"], "Earth");
  EXPECT_EQ(points[0]["crs_unit"], "deg");
  EXPECT_TRUE(points[1]["raster_height_m"].is_null());
}

TEST(Terrain, options_say_what_the_raster_leaves_open) {
  LSOS_NEEDS_REFERENCE("dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif");
  const std::string file = reference_file("dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif");
  const auto height_m = [&](const Words& more) {
    Words words{file, "--at", "-46.765479998,25.047665159"};
    words.insert(words.end(), more.begin(), more.end());
    return terrain(words)[0]["raster_height_m"].get<double>();
  };
  EXPECT_NEAR(height_m({}), -1357.8892, 1e-3);
  EXPECT_NEAR(height_m({"--band", "qts_demstack"}), -1357.8892, 1e-3);
  EXPECT_NEAR(height_m({"--band", "1", "--unit", "ft"}), -1357.8892 * 0.3048, 1e-3);
  EXPECT_GT(height_m({"--band", "2"}), 0);
  const Outcome slip = run({"terrain", file, "--at", "0,0", "--band", "qts_demstak"});
  EXPECT_EQ(slip.exit_code, 2);
  EXPECT_THAT(slip.err, HasSubstr("did you mean 'qts_demstack'?"));
}

TEST(Terrain, exports_a_raster_on_its_own_grid_as_gdal_reads_it) {
  LSOS_NEEDS_REFERENCE("dem/earth/ames_roverscape_0p5m_UTM10.tif");
  const std::string file = reference_file("dem/earth/ames_roverscape_0p5m_UTM10.tif");
  const TempFolder folder;
  const std::string out = folder / "out.tif";
  terrain({file, "--export", out});
  Map ours(out), theirs(file);
  EXPECT_TRUE(ours.dataset().GetSpatialRef()->IsSame(theirs.dataset().GetSpatialRef()));
  ASSERT_EQ(ours.dataset().GetRasterXSize(), theirs.dataset().GetRasterXSize());
  ASSERT_EQ(ours.dataset().GetRasterYSize(), theirs.dataset().GetRasterYSize());
  for (int row = 0; row < ours.dataset().GetRasterYSize(); ++row) {
    for (int column = 0; column < ours.dataset().GetRasterXSize(); ++column) {
      const double a = ours.value(column, row), b = theirs.value(column, row);
      ASSERT_TRUE(std::abs(a - b) < 1e-4 || (std::isnan(a) && std::isnan(b)))
          << column << " " << row << ": " << a << " " << b;
    }
  }
}

TEST(Terrain, exports_a_cloud_optimised_file_and_nothing_beside_it) {
  const TempFolder folder;
  const json answer = terrain({"Craters", "--seed", "7", "--window", "10,20,10.02,20.02",
                               "--resolution", "2", "--export", folder / "out.tif"});
  EXPECT_EQ(answer[0]["file"], (folder / "out.tif").string());
  Map map(folder / "out.tif");
  const char* layout = map.dataset().GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE");
  ASSERT_NE(layout, nullptr);
  EXPECT_STREQ(layout, "COG");
  EXPECT_STREQ(map.dataset().GetRasterBand(1)->GetUnitType(), "m");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}), 1);
  // The site is the window's centre.
  expect_agreement(map, {"Craters", "--seed", "7", "--site", "10.01,20.01"}, 1e-3);
}

// Detail much smaller than a cell is not exported.
TEST(Terrain, exports_coarsely_what_is_large) {
  const TempFolder folder;
  terrain({"LunarSouthPole", "--window", "0,-88.05,5,-88", "--resolution", "20", "--export",
           folder / "out.tif"});
  Map map(folder / "out.tif");
  expect_agreement(map, {"LunarSouthPole", "--site", "2.5,-88.025"}, 0.5);
}

TEST(Terrain, exports_windows_through_the_pole_and_across_the_antimeridian) {
  LSOS_NEEDS_REFERENCE("dem/moon/LDEM_4.LBL");
  const std::string file = reference_file("dem/moon/LDEM_4.LBL");
  const TempFolder folder;
  for (const char* window :
       {"-180,-90,180,-85", "100,84,-100,90", "179,-1,-179,1", "170,-20,190,-10", "-5,58,5,61"}) {
    const std::string out = folder / "out.tif";
    terrain({file, "--window", window, "--resolution", "2000", "--export", out});
    Map map(out);
    SCOPED_TRACE(window);
    EXPECT_GT(map.dataset().GetRasterXSize(), 20);
    EXPECT_LT(map.dataset().GetRasterXSize(), 400);
    expect_agreement(map, {file}, 2e-3);
  }
  // A window on the raster's own grid, across its seam at longitude 0.
  const std::string own = folder / "own.tif";
  terrain({file, "--window", "-10,-5,10,5", "--export", own});
  Map map(own);
  // The cells measure a quarter of a degree; cells that the window's borders touch count too.
  EXPECT_NEAR(map.dataset().GetRasterXSize(), 80, 2);
  EXPECT_NEAR(map.dataset().GetRasterYSize(), 40, 2);
  expect_agreement(map, {file}, 2e-3);
}

TEST(Terrain, exports_to_a_map_of_earth) {
  LSOS_NEEDS_REFERENCE("dem/formats/gdal_n43.dt0");
  const std::string file = reference_file("dem/formats/gdal_n43.dt0");
  const TempFolder folder;
  terrain({file, "--window", "-79.7,43.2,-79.5,43.4", "--resolution", "200", "--export",
           folder / "out.tif"});
  Map map(folder / "out.tif");
  EXPECT_STREQ(map.dataset().GetSpatialRef()->GetAuthorityCode(nullptr), "32617");
  expect_agreement(map, {file}, 1e-3);
}

TEST(Terrain, exports_a_hillshade_that_gdaldem_would_make) {
  const TempFolder folder;
  const Words window{"Craters", "--window", "10,20,10.02,20.02", "--resolution", "2"};
  const auto exported = [&](const std::string& name, const Words& more) {
    Words words = window;
    words.insert(words.end(), {"--export", folder / name});
    words.insert(words.end(), more.begin(), more.end());
    terrain(words);
    return (folder / name).string();
  };
  const std::string heights = exported("heights.tif", {});
  Map ours(exported("shade.tif", {"--hillshade"}));
  const Outcome gdaldem = run_command(
      {"gdaldem", "hillshade", "-q", "-compute_edges", heights, folder / "gdaldem.tif"});
  ASSERT_EQ(gdaldem.exit_code, 0) << gdaldem.err;
  Map theirs(folder / "gdaldem.tif");
  EXPECT_EQ(ours.dataset().GetRasterBand(1)->GetRasterDataType(), GDT_Byte);
  double low = 255, high = 0;
  for (int row = 0; row < ours.dataset().GetRasterYSize(); row += 3) {
    for (int column = 0; column < ours.dataset().GetRasterXSize(); column += 3) {
      ASSERT_NEAR(ours.value(column, row), theirs.value(column, row), 1);
      low = std::min(low, ours.value(column, row));
      high = std::max(high, ours.value(column, row));
    }
  }
  EXPECT_GT(high - low, 50);  // craters are visible
}

TEST(Terrain, that_cannot_be_written_leaves_nothing) {
  const TempFolder folder;
  const Outcome outcome = run({"terrain", "Flat", "--window", "0,0,0.01,0.01", "--resolution", "10",
                               "--export", folder / "no" / "out.tif"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("out.tif: there is no folder "));
  fs::create_directory(folder / "out.tif");
  const Outcome taken = run({"terrain", "Flat", "--window", "0,0,0.01,0.01", "--resolution", "10",
                             "--export", folder / "out.tif"});
  EXPECT_EQ(taken.exit_code, 2);
  EXPECT_THAT(taken.err, HasSubstr("out.tif: is a folder"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}), 1);
}

// Level ground exists only within 60 degrees of its site.
TEST(Terrain, tells_how_many_exported_cells_have_no_ground) {
  const TempFolder folder;
  const auto exported = [&](const char* window) {
    return terrain({"Flat", std::string("--window=") + window, "--resolution", "100000", "--export",
                    folder / "out.tif"})[0];
  };
  EXPECT_EQ(exported("-30,-30,30,30")["cells_without_value"], 0);
  const json wide = exported("-170,-30,170,30");
  const int cells = wide["columns"].get<int>() * wide["rows"].get<int>();
  Map map(folder / "out.tif");
  int without = 0;
  for (int row = 0; row < wide["rows"]; ++row) {
    for (int column = 0; column < wide["columns"]; ++column) {
      if (std::isnan(map.value(column, row))) ++without;
    }
  }
  EXPECT_GT(without, cells / 2);
  EXPECT_EQ(wide["cells_without_value"], without);
}

TEST(Terrain, of_a_script_reads_its_raster_as_the_script_says) {
  LSOS_NEEDS_REFERENCE("dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif");
  const std::string file = reference_file("dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif");
  const TempFolder folder;
  folder.write("terrain/Plateau.lua",
               "local lsos = require 'lsos'\n"
               "return lsos.terrain { api = 1, doc = 'x', soil = 'ApolloNominal',\n"
               "  surface = lsos.raster { file = '" +
                   file +
                   "', band = 'qts_demstack',\n"
                   "    unit = 'ft', nodata = -1 } }\n");
  const Surroundings where{.environment = {"LSOS_PATH=" + folder.path().string()}};
  const json point = terrain({"Plateau", "--at", "-46.765479998,25.047665159"}, where)[0];
  EXPECT_NEAR(point["raster_height_m"].get<double>(), -1357.8892 * 0.3048, 1e-3);
  EXPECT_NEAR(point["x"].get<double>(), 0, 1e-6);
  EXPECT_EQ(point["body"], "Moon");
  // Without a window, the raster's own grid is exported.
  const json exported = terrain({"Plateau", "--export", folder / "out.tif"}, where)[0];
  EXPECT_EQ(exported["columns"], 256);
  EXPECT_EQ(exported["rows"], 237);
}

}  // namespace
}  // namespace lsos::test
