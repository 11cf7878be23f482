#include <cmath>
#include <sstream>

#include "ground_fixture.h"

namespace lsos {
namespace {

constexpr char nobile[] = "dem/moon/nobile_rim2_ldem_6_cut_1m.tif";

struct TruthPoint {
  double pixel, line, lon_deg, lat_deg, value, bilinear;
};

std::vector<TruthPoint> truth_points(const std::string& raster) {
  std::vector<TruthPoint> points;
  std::ifstream file(reference_file("dem/gdal_truth_points.csv"));
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (cells[0] != raster || cells[1] != "1") continue;
    points.push_back({std::stod(cells[2]), std::stod(cells[3]), std::stod(cells[6]),
                      std::stod(cells[7]), std::stod(cells[8]), std::stod(cells[9])});
  }
  return points;
}

class Nobile : public ::testing::Test {
 protected:
  void SetUp() override { LSOS_NEEDS_REFERENCE(nobile); }
  SiteFrame site = site_on("Moon", 59.173891517, -83.892032334, 1026);
  TerrainSpec spec = raster_terrain(reference_file(nobile));
};

TEST_F(Nobile, is_met_at_cell_centres_within_a_millimetre) {
  const Ground ground(spec, site, 0);
  Ground::Probe probe(ground);
  int centres = 0;
  for (const TruthPoint& truth : truth_points(nobile)) {
    const Geodetic place = geodetic_from_degrees(truth.lon_deg, truth.lat_deg, 1100);
    const auto elevation_m = ground.elevation_m(place);
    ASSERT_TRUE(elevation_m) << truth.pixel << " " << truth.line;
    const GroundSample sample = probe.sample(site.p_S_m(place));
    EXPECT_NEAR(sample.elevation_m, *elevation_m, 1e-5);
    EXPECT_NEAR(sample.gap_m, 1100 - *elevation_m, 1e-5);
    // Cell centres are whole numbers and a half; the places are given to 1e-9 degrees, 0.03 mm.
    if (truth.pixel - std::floor(truth.pixel) == 0.5 &&
        truth.line - std::floor(truth.line) == 0.5) {
      EXPECT_NEAR(*elevation_m, truth.value, 1e-3);
      ++centres;
    } else if (truth.pixel == 500 && truth.line == 500) {
      EXPECT_NEAR(*elevation_m, truth.bilinear, 0.1);
    } else {
      // Bilinear and bicubic heights differ by the curvature within a cell.
      EXPECT_NEAR(*elevation_m, truth.bilinear, 0.05) << truth.pixel << " " << truth.line;
    }
  }
  EXPECT_GT(centres, 0);
}

TEST_F(Nobile, normals_are_gradients_of_the_gap) {
  const Ground ground(spec, site, 0);
  Ground::Probe probe(ground);
  for (double x : {-310.3, -63.98, 0.02, 64.0, 200.7}) {
    for (double y : {-255.9, -12.4, 0.0, 301.2}) {
      const Vec3 p = on_surface(ground, probe, {x, y, 0});
      EXPECT_NEAR(probe.sample(p).gap_m, 0, 1e-8);
      EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1e-4)).norm(), 1e-5);
      // The normal is that of the surface, also when sampled from above.
      const Vec3 above = p + 500 * site.up_S(p);
      EXPECT_LT((probe.sample(above).normal_S - probe.sample(p).normal_S).norm(), 1e-9);
    }
  }
}

// Walks in steps over tile and patch borders: neither height nor normal may jump.
TEST_F(Nobile, is_smooth_across_tiles_and_patches) {
  const Ground ground(spec, site, 0);
  Ground::Probe probe(ground);
  // Around a border of patches (x = 0, 256) and along 200 m, which crosses tiles of 64 cells.
  for (double x : {0.0, 256.0}) {
    for (double y = -200; y < 0; y += 0.37) {
      const GroundSample before = probe.sample({x - 1e-7, y, 0});
      const GroundSample after = probe.sample({x + 1e-7, y, 0});
      // The rise over 2e-7 m on slopes below 1/2; what is above that would be a step.
      EXPECT_NEAR(before.elevation_m, after.elevation_m, 1.1e-7);
      EXPECT_LT((before.normal_S - after.normal_S).norm(), 1e-6);
    }
  }
  GroundSample last = probe.sample({-150, -150.3, 0});
  for (double x = -150 + 0.001; x < -20; x += 0.001) {
    const GroundSample here = probe.sample({x, -150.3 + 0.7 * (x + 150), 0});
    ASSERT_LT(std::abs(here.elevation_m - last.elevation_m), 0.002);
    ASSERT_LT((here.normal_S - last.normal_S).norm(), 0.003) << x;
    last = here;
  }
}

TEST_F(Nobile, slopes_are_near_those_of_gdaldem) {
  const Ground ground(spec, site, 0);
  std::ifstream file(reference_file("dem/gdaldem_truth.csv"));
  int checked = 0;
  double sum_deg = 0;
  for (std::string line; std::getline(file, line);) {
    std::stringstream cells(line);
    std::string name, pixel, row, horn;
    std::getline(std::getline(std::getline(std::getline(cells, name, ','), pixel, ','), row, ','),
                 horn, ',');
    if (name != nobile) continue;
    // Place of the cell in closed form: polar stereographic, true scale at the pole.
    const double east_m = 158699 + std::stod(pixel) + 0.5;
    const double north_m = 95500 - std::stod(row) - 0.5;
    const double colatitude_rad = 2 * std::atan(std::hypot(east_m, north_m) / (2 * 1737400));
    const Geodetic place{std::atan2(east_m, north_m), colatitude_rad - M_PI / 2, 1000};
    Ground::Probe probe(ground);
    const Vec3 p = site.p_S_m(place);
    const double slope_deg = std::acos(probe.sample(p).normal_S.dot(site.up_S(p))) * 180 / M_PI;
    EXPECT_NEAR(slope_deg, std::stod(horn), 3) << pixel << " " << row;
    sum_deg += slope_deg - std::stod(horn);
    ++checked;
  }
  ASSERT_GT(checked, 5);
  EXPECT_NEAR(sum_deg / checked, 0, 0.3);
}

TEST_F(Nobile, ends_half_a_cell_beyond_the_outermost_centres) {
  const Ground ground(spec, site, 0);
  // Stereographic coordinates of the raster's corner, then a little outside and inside of it.
  const auto at = [](double east_m, double north_m) {
    const double colatitude_rad = 2 * std::atan(std::hypot(east_m, north_m) / (2 * 1737400));
    return Geodetic{std::atan2(east_m, north_m), colatitude_rad - M_PI / 2, 0};
  };
  EXPECT_TRUE(ground.elevation_m(at(158699.01, 95499.99)));
  EXPECT_FALSE(ground.elevation_m(at(158698.99, 95499.99)));
  EXPECT_FALSE(ground.elevation_m(at(158699.01, 95500.01)));
  EXPECT_TRUE(ground.elevation_m(at(159698.99, 94500.01)));
  EXPECT_FALSE(ground.elevation_m(at(159699.01, 94500.01)));
  EXPECT_FALSE(ground.elevation_m(geodetic_from_degrees(10, 20)));
  Ground::Probe probe(ground);
  EXPECT_FALSE(probe.sample({5000, 0, 0}).is_ground());
  EXPECT_FALSE(probe.sample({0, 0, -4e6}).is_ground());
}

TEST_F(Nobile, hash_names_the_ground_and_not_the_site) {
  const std::string hash = Ground(spec, site, 0).hash();
  EXPECT_EQ(hash.size(), 64u);
  EXPECT_EQ(Ground(spec, site_on("Moon", 59.2, -83.9), 7).hash(), hash);
}

struct OtherRaster {
  const char* file;
  const char* body;
  double height_tolerance_m;  // between bilinear and bicubic
};

class OtherRasters : public ::testing::TestWithParam<OtherRaster> {};

TEST_P(OtherRasters, lie_where_gdal_says) {
  const auto& [name, body, tolerance_m] = GetParam();
  LSOS_NEEDS_REFERENCE(name);
  const std::vector<TruthPoint> points = truth_points(name);
  ASSERT_FALSE(points.empty());
  const SiteFrame site = site_on(body, points[1].lon_deg, points[1].lat_deg);
  const Ground ground(raster_terrain(reference_file(name)), site, 0);
  Ground::Probe probe(ground);
  int checked = 0;
  for (const TruthPoint& truth : points) {
    if (std::isnan(truth.value) || std::isnan(truth.bilinear)) continue;
    const Geodetic place = geodetic_from_degrees(truth.lon_deg, truth.lat_deg);
    const auto elevation_m = ground.elevation_m(place);
    if (!elevation_m) continue;  // beside missing cells
    const bool is_centre =
        truth.pixel - std::floor(truth.pixel) == 0.5 && truth.line - std::floor(truth.line) == 0.5;
    EXPECT_NEAR(*elevation_m, is_centre ? truth.value : truth.bilinear,
                is_centre ? 1e-3 : tolerance_m);
    EXPECT_NEAR(probe.sample(site.p_S_m(place)).elevation_m, *elevation_m, 1e-5);
    ++checked;
  }
  EXPECT_GT(checked, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Raster, OtherRasters,
    ::testing::Values(OtherRaster{"dem/mars/gale_hirise_1m_missionDEM.tif", "Mars", 0.1},
                      OtherRaster{"dem/moon/aristarchus_IMP_4p76m_height_slope_rock.tif", "Moon",
                                  1},
                      OtherRaster{"dem/earth/ames_roverscape_0p5m_UTM10.tif", "Earth", 0.1}));

// Somebody writes a raster anew while a run reads it.
TEST(Raster, tells_which_of_its_files_have_changed_since_it_was_opened) {
  TextRaster raster{"IAU_2015:30110", "-50,1,0,50,0,-1", "",
                    rows_of(100, 100, [](int, int) { return 5.0; })};
  const std::string vrt = raster.write("ground");
  const std::string source = vrt.substr(0, vrt.size() - 4) + ".asc";
  const Ground ground(raster_terrain(vrt), site_on("Moon", 0, 0), 0);
  EXPECT_THAT(ground.changed_files(), ::testing::IsEmpty());
  std::ofstream(vrt + ".aux.xml") << "<PAMDataset/>";
  EXPECT_THAT(ground.changed_files(), ::testing::IsEmpty());
  // As long as before, in the same file.
  std::fstream(source).write("n", 1);
  EXPECT_THAT(ground.changed_files(), ::testing::ElementsAre(source));
  std::filesystem::remove(vrt);
  EXPECT_THAT(ground.changed_files(), ::testing::ElementsAre(source, vrt));
}

}  // namespace
}  // namespace lsos
