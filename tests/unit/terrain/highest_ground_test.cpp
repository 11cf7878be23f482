// Upper bounds on the ground of a region, against samples in it.
#include <cmath>
#include <numbers>
#include <random>

#include "ground_fixture.h"
#include "support/cratered_terrain.h"

namespace lsos {
namespace {

TerrainSpec cratered() {
  TerrainSpec spec = cratered_terrain(1);
  spec.detail->rocks.emplace();
  spec.detail->rocks->cover = 0.01;
  spec.detail->rocks->diameter_min_m = 0.2;
  return spec;
}

// How the bounds of regions of ten times the resolution compare with 400 samples in each.
struct Bounds {
  int known = 0;
  double least_over_m = 1e9;  // bound above the highest sample
  double mean_over_m = 0;
};

Bounds bounds(const Ground& ground, double resolution_m, double within_m, int count) {
  auto probe = Ground::Probe::with_sparse_detail(ground, resolution_m);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  Bounds found;
  const double side_m = 10 * std::max(resolution_m, 0.1);
  for (int k = 0; k < count; ++k) {
    const Vec3 middle(within_m * unit(random), within_m * unit(random), 0);
    const double angle = std::numbers::pi * unit(random);
    const Vec3 u = side_m / 2 * Vec3(std::cos(angle), std::sin(angle), 0);
    const Vec3 v = side_m / 2 * Vec3(-std::sin(angle), std::cos(angle), 0);
    const std::vector<Vec3> corners{middle - u - v, middle - u + v, middle + u - v, middle + u + v};
    const std::optional<double> bound_m = probe.highest_m(corners);
    if (!bound_m) continue;
    double highest_m = -1e9;
    for (int j = 0; j < 400; ++j) {
      const GroundSample sample = probe.sample(middle + unit(random) * u + unit(random) * v);
      highest_m = std::max(highest_m, sample.elevation_m);
    }
    ++found.known;
    found.least_over_m = std::min(found.least_over_m, *bound_m - highest_m);
    found.mean_over_m += *bound_m - highest_m;
  }
  found.mean_over_m /= std::max(1, found.known);
  return found;
}

TEST(HighestGround, bounds_craters_and_rocks_at_every_resolution) {
  const Ground ground(cratered(), site_on("Moon", 2, -85.05), 3);
  for (const double resolution_m : {0.0, 0.2, 1.6, 12.8, 102.4}) {
    const Bounds found = bounds(ground, resolution_m, 100 * std::max(resolution_m, 0.5), 200);
    std::printf(
        "resolution %5.1f m: %d known, %.3f m over the highest sample at least, %.3f on "
        "average\n",
        resolution_m, found.known, found.least_over_m, found.mean_over_m);
    EXPECT_EQ(found.known, 200);
    EXPECT_GE(found.least_over_m, 0);
    // A region of ten resolutions on a slope of 10 degrees rises by 1.8 of them.
    EXPECT_LT(found.mean_over_m, 3 * std::max(resolution_m, 0.2));
  }
}

TEST(HighestGround, of_a_level_plane_is_its_height) {
  const Ground ground(plane_terrain(120), site_on("Moon", 10, 20), 0);
  const Bounds found = bounds(ground, 1.6, 1000, 50);
  EXPECT_EQ(found.known, 50);
  EXPECT_NEAR(found.least_over_m, 0, 1e-6);
  EXPECT_NEAR(found.mean_over_m, 0, 1e-6);
}

TEST(HighestGround, is_unknown_at_holes_and_beyond_the_edge) {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-200,2,0,200,0,-2",
                          "<NoDataValue>-9999</NoDataValue>",
                          rows_of(200, 200, [](int column, int row) {
                            const bool is_hole = std::hypot(column - 150, row - 100) < 8;
                            return is_hole ? -9999 : 30 * std::sin(column * 0.05);
                          })};
  const Ground ground(raster_terrain(raster.write("hole")), site_on("Moon", 0, 0), 0);
  auto probe = Ground::Probe::with_sparse_detail(ground, 2);
  const auto about = [&](double x_m, double y_m) {
    const std::vector<Vec3> corners{{x_m - 10, y_m - 10, 0},
                                    {x_m + 10, y_m - 10, 0},
                                    {x_m - 10, y_m + 10, 0},
                                    {x_m + 10, y_m + 10, 0}};
    return probe.highest_m(corners);
  };
  EXPECT_TRUE(about(0, 0));
  EXPECT_FALSE(about(100, 0));
  EXPECT_FALSE(about(195, 0));
  EXPECT_FALSE(about(1000, 0));
  const Bounds found = bounds(ground, 2, 80, 200);
  EXPECT_GT(found.known, 150);
  EXPECT_GE(found.least_over_m, 0);
}

// A map in longitude and latitude has a seam, and at a pole all columns meet: what lies between the
// columns of a region's corners is then not what lies in the region.
TEST(HighestGround, is_right_or_unknown_at_the_seam_and_the_pole_of_a_globe) {
  const TextRaster globe{"+proj=longlat +R=1737400", "-180,0.5,0,90,0,-0.5", "",
                         rows_of(720, 360, [](int column, int row) {
                           return 500.0 * ((column * 7 + row * 13) % 11) + (row < 2 ? 9000 : 0);
                         })};
  const TerrainSpec spec = raster_terrain(globe.write("globe"));
  int known = 0;
  for (const auto& [lon_deg, lat_deg] : {std::pair{180.0, 0.0},
                                         {-179.7, 40.0},
                                         {0.0, 89.8},
                                         {77.0, 89.0},
                                         {30.0, 86.0},
                                         {12.0, 5.0}}) {
    const Ground ground(spec, site_on("Moon", lon_deg, lat_deg), 0);
    for (const double resolution_m : {3e3, 1e4, 4e4}) {
      const Bounds found = bounds(ground, resolution_m, 2 * resolution_m, 40);
      known += found.known;
      EXPECT_GE(found.least_over_m, 0) << lon_deg << " " << lat_deg << " at " << resolution_m;
    }
  }
  EXPECT_GT(known, 100);
}

TEST(HighestGround, bounds_ground_where_a_fine_layer_fades_into_a_coarse_one) {
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-150,2,0,150,0,-2", "",
                        rows_of(150, 150, [](int column, int) { return 20 + column % 7; })};
  const TextRaster coarse{"+proj=eqc +R=1737400 +units=m", "-4000,40,0,4000,0,-40", "",
                          rows_of(200, 200, [](int, int row) { return 3.0 * (row % 5); })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.push_back(RasterSurface{coarse.write("coarse"), 1});
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  const Bounds found = bounds(ground, 2, 200, 400);
  EXPECT_GT(found.known, 300);
  EXPECT_GE(found.least_over_m, 0);
}

}  // namespace
}  // namespace lsos
