// `lsos-host sight` as a user runs it, and its maps compared with GDAL's viewshed.
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>

#include "support/reference_data.h"
#include "system/sight_map.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr double pi = 3.14159265358979323846;

struct Cut {
  const char* file;
  int column, row, columns, rows;  // window; 0 columns: the whole raster
  unsigned observers = 4;
};

// Some users give a place with its elevation in the map instead of its height above the ground.
TEST(SightHeight, that_is_the_ground_s_own_elevation_is_asked_about) {
  const auto errors_for = [](const std::string& height) {
    const std::filesystem::path raster = repository() / "tests/messages/mission/high.asc";
    return run({"sight", raster, "--from", "0,0," + height, "--to", "0.001,0.001,2"},
               {.environment = {"GDAL_PAM_ENABLED=NO"}})
        .err;
  };
  EXPECT_THAT(errors_for("502"),
              HasSubstr("--from 0,0,502: H = 502 m is above the ground, which lies at "));
  EXPECT_EQ(errors_for("2"), "");
}

// Writes a part of a raster as a file.
std::string cut(const Cut& from, const TempFolder& folder) {
  const Dataset whole = opened(reference_file(from.file));
  const std::string file = folder / "cut.tif";
  Words words{"gdal_translate", "-q", "-b", "1"};
  if (from.columns > 0) {
    words.insert(words.end(), {"-srcwin", std::to_string(from.column), std::to_string(from.row),
                               std::to_string(from.columns), std::to_string(from.rows)});
  }
  words.insert(words.end(), {reference_file(from.file), file});
  const Outcome outcome = run_command(words, {.environment = {"GDAL_PAM_ENABLED=NO"}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return file;
}

// Share of cells for which GDAL and the program agree.
double agreement(const std::string& file, std::mt19937& random, bool is_flat,
                 const TempFolder& folder) {
  const Dataset dataset = opened(file);
  const std::vector<double> heights_m = samples(*dataset);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  int has_nodata = FALSE;
  const double nodata = band.GetNoDataValue(&has_nodata);
  const int columns = band.GetXSize(), rows = band.GetYSize();
  int column = 0, row = 0;
  const auto is_missing = [&](std::size_t k) {
    return std::isnan(heights_m[k]) || (has_nodata != FALSE && heights_m[k] == nodata) ||
           heights_m[k] < -20000;
  };
  const auto at = [&](int u, int v) {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(u);
  };
  const auto pick = [&](int count) { return 1 + static_cast<int>(random() % (count - 2u)); };
  const auto is_whole = [&] {
    for (int v = row - 1; v <= row + 1; ++v) {
      for (int u = column - 1; u <= column + 1; ++u) {
        if (is_missing(at(u, v))) return false;
      }
    }
    return true;
  };
  do {
    column = pick(columns);
    row = pick(rows);
  } while (!is_whole());
  constexpr double eyes_m[] = {1, 2, 5, 20}, targets_m[] = {0, 0.5, 2};
  const double eye_m = eyes_m[random() % 4], target_m = targets_m[random() % 3];
  const CellPlace place = cell_place(*dataset, column, row);
  const Dataset theirs(GDALDataset::FromHandle(GDALViewshedGenerate(
      GDALRasterBand::ToHandle(&band), "MEM", "", nullptr, place.x, place.y, eye_m, target_m, 1, 0,
      0, 0, is_flat ? 0 : 1, GVM_Edge, 0, nullptr, nullptr, GVOT_NORMAL, nullptr)));
  Words words{file,
              "--from",
              fmt::format("{},{}", place.lon_lat, eye_m),
              "--height",
              fmt::format("{}", target_m),
              "-o",
              folder / "seen.tif"};
  if (is_flat) words.emplace_back("--flat");
  sight(words);
  const Dataset ours = opened(folder / "seen.tif");
  if (!theirs || !ours) return 0;
  const std::vector<double> a = samples(*ours), b = samples(*theirs);
  double alike = 0, cells = 0, seen = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(std::isnan(a[k]), is_missing(k));
    if (is_missing(k)) continue;
    ++cells;
    seen += a[k];
    alike += a[k] == b[k] ? 1 : 0;
  }
  std::printf("  cell %d,%d, eye %g m, target %g m, %s: %.2f %% alike, %.1f %% seen\n", column, row,
              eye_m, target_m, is_flat ? "flat" : "round", 100 * alike / cells, 100 * seen / cells);
  return alike / cells;
}

class Viewshed : public ::testing::TestWithParam<Cut> {};

// GDAL's viewshed propagates horizons from cell to cell (Wang et al. 2000); the program's follows
// rays, and on small maps the line to each cell. They differ at the edges of hidden areas: the
// least agreement is 97.2 % (33 x 33 rough cells, 120 observers), and 99.3 % for all others. Cells
// without samples are left out, because GDAL takes them for heights.
TEST_P(Viewshed, is_that_of_gdal) {
  LSOS_NEEDS_REFERENCE(GetParam().file);
  const TempFolder folder;
  const std::string file = cut(GetParam(), folder);
  std::printf("%s\n", GetParam().file);
  for (unsigned seed = 1; seed <= GetParam().observers; ++seed) {
    for (const bool is_flat : {false, true}) {
      std::mt19937 random(seed);
      EXPECT_GE(agreement(file, random, is_flat, folder), 0.97);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    of_projected_rasters, Viewshed,
    ::testing::Values(Cut{"dem/moon/nobile_rim2_ldem_6_cut_1m.tif", 300, 200, 400, 400},
                      Cut{"dem/moon/gz_dem_moon_87p5N.tif", 0, 0, 0, 0, 20},
                      Cut{"dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif", 0, 0, 250, 230},
                      Cut{"dem/mars/gale_hirise_1m_missionDEM.tif", 0, 0, 0, 0},
                      Cut{"dem/earth/ames_roverscape_0p5m_UTM10.tif", 0, 0, 0, 0}));

TEST(Sight, answers_with_the_fields_of_the_contract) {
  const json lines =
      sight({"Flat", "--planet", "Moon", "--from", "30,10,2", "--to", "30,10.05,2", "--to",
             "30.1,10,30", "--to", "30,9.8,2", "--to", "30,10,2", "--to", "30,10,7"});
  ASSERT_EQ(lines.size(), 5u);
  const double degree_m = 1737400 * pi / 180;
  EXPECT_EQ(lines[0]["visible"], 1);
  EXPECT_NEAR(lines[0]["distance_m"].get<double>(), 0.05 * degree_m, 0.01);
  EXPECT_NEAR(lines[0]["azimuth_deg"].get<double>(), 0, 1e-6);
  // The line points below the horizontal by half of the angle between both verticals.
  EXPECT_NEAR(lines[0]["elevation_deg"].get<double>(), -0.025, 1e-6);
  EXPECT_NEAR(lines[1]["azimuth_deg"].get<double>(), 90 - 0.05 * std::sin(10 * pi / 180), 1e-3);
  EXPECT_EQ(lines[1]["visible"], 1);
  EXPECT_EQ(lines[2]["visible"], 0);  // 6.06 km; horizons of 2 m meet at 5.27 km
  EXPECT_NEAR(lines[2]["azimuth_deg"].get<double>(), 180, 1e-6);
  EXPECT_EQ(lines[3]["visible"], 1);
  EXPECT_EQ(lines[3]["distance_m"], 0);
  EXPECT_TRUE(lines[3]["azimuth_deg"].is_null());
  EXPECT_TRUE(lines[3]["elevation_deg"].is_null());
  EXPECT_EQ(lines[4]["visible"], 1);
  EXPECT_TRUE(lines[4]["azimuth_deg"].is_null());
  EXPECT_NEAR(lines[4]["elevation_deg"].get<double>(), 90, 1e-6);
}

TEST(Sight, is_the_same_for_any_number_of_threads) {
  const TempFolder folder;
  const auto map = [&](const std::string& threads) {
    const std::string file = folder / (threads + ".tif");
    json answer =
        sight({"Craters", "--from", "30,10,0.5", "--height", "0", "--threads", threads,
               "--window=29.998,9.998,30.002,10.003", "--resolution", "1", "-o", file})[0];
    EXPECT_GT(answer["seen_share"].get<double>(), 0.02);
    EXPECT_LT(answer["seen_share"].get<double>(), 0.98);
    return read_text(file);
  };
  EXPECT_EQ(map("1"), map("3"));
}

// A map of a window beside the observer equals that part of the map around the observer.
TEST(Sight, of_a_window_aside_is_that_of_the_whole_map) {
  constexpr char raster[] = "dem/moon/nobile_rim2_ldem_6_cut_1m.tif";
  LSOS_NEEDS_REFERENCE(raster);
  const TempFolder folder;
  const std::string file = cut({raster, 300, 200, 400, 400}, folder);
  const Dataset dataset = opened(file);
  const CellPlace eye = cell_place(*dataset, 60, 200), low = cell_place(*dataset, 250, 300),
                  high = cell_place(*dataset, 350, 220);
  const auto number = [](const CellPlace& place, std::size_t which) {
    const std::size_t comma = place.lon_lat.find(',');
    return std::stod(which == 0 ? place.lon_lat.substr(0, comma) : place.lon_lat.substr(comma + 1));
  };
  const auto [west, east] = std::minmax({number(low, 0), number(high, 0)});
  const auto [south, north] = std::minmax({number(low, 1), number(high, 1)});
  const Words question{file, "--from", eye.lon_lat + ",5", "--height", "1", "-o"};
  Words all = question, part = question;
  all.emplace_back(folder / "all.tif");
  part.insert(part.end(), {folder / "part.tif", fmt::format("--window={:.9f},{:.9f},{:.9f},{:.9f}",
                                                            west, south, east, north)});
  sight(all);
  sight(part);
  const Dataset whole = opened(folder / "all.tif"), aside = opened(folder / "part.tif");
  ASSERT_TRUE(whole && aside);
  double a[6], b[6];
  whole->GetGeoTransform(a);
  aside->GetGeoTransform(b);
  const int u0 = static_cast<int>(std::lround((b[0] - a[0]) / a[1]));
  const int v0 = static_cast<int>(std::lround((b[3] - a[3]) / a[5]));
  const std::vector<double> of_whole = samples(*whole), of_part = samples(*aside);
  const int columns = aside->GetRasterXSize(), rows = aside->GetRasterYSize();
  double alike = 0;
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      alike += of_part[static_cast<std::size_t>(v * columns + u)] ==
                       of_whole[static_cast<std::size_t>((v + v0) * 400 + u + u0)]
                   ? 1
                   : 0;
    }
  }
  EXPECT_GT(alike / (rows * columns), 0.99);
  EXPECT_GT(rows * columns, 2000);
}

TEST(Sight, says_what_it_cannot_answer) {
  LSOS_NEEDS_REFERENCE("dem/moon/nobile_rim2_ldem_6_cut_1m.tif");
  const Outcome beyond = run({"sight", reference_file("dem/moon/nobile_rim2_ldem_6_cut_1m.tif"),
                              "--from", "59,-80,2", "--to", "59.1741,-83.892,2", "--to", "0,0,2"});
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_THAT(beyond.err, HasSubstr("--from 59,-80,2: there is no ground; the terrain does not"));
  EXPECT_THAT(beyond.err, HasSubstr("--to 0,0,2: there is no ground"));
  const TempFolder folder;
  const Outcome flat = run({"sight", "Flat", "--from", "0,0,2", "--height", "1", "--flat", "-o",
                            folder / "x.tif", "--window=-170,-80,170,80", "--resolution", "50000"});
  EXPECT_EQ(flat.exit_code, 2);
  EXPECT_THAT(flat.err, HasSubstr("--flat: the map reaches"));
}

}  // namespace
}  // namespace lsos::test
