// Coarse levels of detail: what is much smaller than the resolution is left out, the rest stays.
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <numbers>

#include "ground_fixture.h"
#include "terrain/grid/key_cache.h"

namespace lsos {
namespace {

// RMS of the difference between coarse and full resolution, and of the latter about its mean, over
// points on a circle of that radius.
struct Difference {
  double rms_m;
  double relief_m;
};

Difference difference(const Ground& ground, double resolution_m, double radius_m) {
  Ground::Probe close(ground), far(ground, resolution_m);
  double sum = 0, sum2 = 0, apart2 = 0;
  constexpr int count = 2000;
  for (int k = 0; k < count; ++k) {
    const double r = radius_m * std::sqrt((k + 0.5) / count), angle = 2.399963 * k;
    const Vec3 p{r * std::cos(angle), r * std::sin(angle), 0};
    const double height_m = close.sample(p).elevation_m;
    sum += height_m;
    sum2 += height_m * height_m;
    apart2 += std::pow(far.sample(p).elevation_m - height_m, 2);
  }
  return {std::sqrt(apart2 / count), std::sqrt(sum2 / count - std::pow(sum / count, 2))};
}

TEST(Look, at_a_raster_keeps_what_is_larger_than_the_resolution) {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-512,2,0,512,0,-2", "",
                          rows_of(512, 512, [](int column, int row) {
                            return 30 * std::sin(column * 0.02) + 20 * std::cos(row * 0.03) +
                                   0.1 * ((column + row) % 2);
                          })};
  const Ground ground(raster_terrain(raster.write("waves")), site_on("Moon", 0, 0), 0);
  // One of 8 x 8 samples stands for all: it lies half a cell, 1 m, beside their middle on each
  // axis, on a slope of 0.3.
  const Difference d = difference(ground, 16, 450);
  EXPECT_LT(d.rms_m, 0.45);
  EXPECT_GT(d.rms_m, 0.01);
  EXPECT_GT(d.relief_m, 20);
  const Geodetic place = geodetic_from_degrees(0.003, 0.002);
  EXPECT_NEAR(*ground.elevation_m(place, 16), *ground.elevation_m(place), 1);
  EXPECT_EQ(*ground.elevation_m(place, 2), *ground.elevation_m(place));
}

// The same globe cut at 180 degrees and at 0, with waves of 30 degrees.
TEST(Look, goes_around_the_body) {
  const auto globe = [](const char* name, int first_lon_deg) {
    const TextRaster raster{"+proj=longlat +R=1737400",
                            std::to_string(first_lon_deg) + ",1,0,90,0,-1", "",
                            rows_of(360, 180, [&](int column, int) {
                              const double lon_deg = first_lon_deg + column;
                              return 1000 * std::cos(12 * lon_deg * std::numbers::pi / 180);
                            })};
    return raster_terrain(raster.write(name));
  };
  const SiteFrame site = site_on("Moon", 180, 0);
  const Ground ground(globe("globe", -180), site, 0), turned(globe("turned", 0), site, 0);
  const double resolution_m = 4 * 1737400 * std::numbers::pi / 180;
  for (double lon_deg = 170; lon_deg < 190; lon_deg += 0.37) {
    const Geodetic place = geodetic_from_degrees(lon_deg, 3);
    const double height_m = *ground.elevation_m(place, resolution_m);
    EXPECT_NEAR(height_m, *turned.elevation_m(place, resolution_m), 1e-6) << lon_deg;
    // One sample stands half a degree beside the middle of four, at 209 m a degree.
    EXPECT_NEAR(height_m, *ground.elevation_m(place), 160) << lon_deg;
  }
}

// A globe whose last column repeats its first, as cylinder maps on grid lines have it.
TEST(Look, goes_around_a_body_that_overlaps_itself) {
  const auto height = [](double lon_deg) {
    return 1000 * std::cos(12 * lon_deg * std::numbers::pi / 180);
  };
  const TextRaster raster{
      "+proj=longlat +R=1737400", "-180.5,1,0,90,0,-1", "",
      rows_of(361, 180, [&](int column, int) { return height(-180 + column); })};
  const Ground ground(raster_terrain(raster.write("lines")), site_on("Moon", 180, 0), 0);
  const double degree_m = 1737400 * std::numbers::pi / 180;
  for (const double resolution_m : {0.0, 2 * degree_m}) {
    // Cubics through samples one degree apart of waves of 30 degrees; half a degree off at 209 m.
    const double error_m = resolution_m == 0 ? 3 : 110;
    for (double lon_deg = 175; lon_deg < 185; lon_deg += 0.23) {
      const auto height_m = ground.elevation_m(geodetic_from_degrees(lon_deg, 3), resolution_m);
      ASSERT_TRUE(height_m) << lon_deg;
      EXPECT_NEAR(*height_m, height(lon_deg), error_m) << lon_deg;
    }
  }
}

// A hole at a coarse level is a hole, no larger than by the level's cells; the rest is the rest.
TEST(Look, at_a_raster_with_a_hole) {
  const auto height = [](int column, int row) { return 0.2 * column + 0.1 * row; };
  const TextRaster raster{
      "+proj=eqc +R=1737400 +units=m", "-256,2,0,256,0,-2", "<NoDataValue>-9999</NoDataValue>",
      rows_of(256, 256, [&](int column, int row) {
        const bool is_hole = std::abs(column - 128) < 24 && std::abs(row - 128) < 24;
        return is_hole ? -9999 : height(column, row);
      })};
  const Ground ground(raster_terrain(raster.write("hole")), site_on("Moon", 0, 0), 0);
  Ground::Probe close(ground);
  for (const double resolution_m : {4.0, 8.0, 16.0}) {
    Ground::Probe far(ground, resolution_m);
    EXPECT_FALSE(far.sample({0, 0, 0}).is_ground()) << resolution_m;
    for (double angle = 0; angle < 6.28; angle += 0.1) {
      // The hole ends 48 m from the middle, at its corners 68 m.
      const double r_m = 70 + 2 * resolution_m;
      const Vec3 p_S_m{r_m * std::cos(angle), r_m * std::sin(angle), 0};
      const GroundSample there = far.sample(p_S_m);
      ASSERT_TRUE(there.is_ground()) << resolution_m << " " << angle;
      EXPECT_NEAR(there.elevation_m, close.sample(p_S_m).elevation_m, 0.1 * resolution_m);
    }
  }
}

// From the fine raster out over its edge into the coarse one, at full and at coarse resolution.
TEST(Look, at_a_raster_in_another_has_no_step) {
  const auto waves = [](double x_m, double y_m) {
    return 5 * std::sin(x_m / 60) + 4 * std::cos(y_m / 80);
  };
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-256,2,0,256,0,-2", "",
                        rows_of(256, 256, [&](int column, int row) {
                          return waves(-255 + 2 * column, 255 - 2 * row);
                        })};
  const TextRaster coarse{"+proj=eqc +R=1737400 +units=m", "-1000,20,0,1000,0,-20", "",
                          rows_of(100, 100, [&](int column, int row) {
                            return waves(-990 + 20 * column, 990 - 20 * row);
                          })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.push_back(raster_terrain(coarse.write("coarse")).layers.front());
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  Ground::Probe close(ground);
  for (const double resolution_m : {8.0, 16.0, 40.0, 80.0}) {
    Ground::Probe far(ground, resolution_m);
    double before_m = far.sample({-600, 3, 0}).elevation_m;
    for (double x_m = -599.5; x_m < 600; x_m += 0.5) {
      const double height_m = far.sample({x_m, 3, 0}).elevation_m;
      // Half a cell of the level off on slopes of 5/60, and what a cubic misses of the waves.
      EXPECT_NEAR(height_m, close.sample({x_m, 3, 0}).elevation_m, 0.05 * resolution_m + 0.1)
          << x_m;
      EXPECT_NEAR(height_m, before_m, 0.12) << resolution_m << " " << x_m;
      before_m = height_m;
    }
  }
}

// An odd number of columns and an overview that halves it: the tiles of a level agree on the nodes
// that they share, and the ground is where it is without the overview.
TEST(Look, through_overviews_has_no_seam) {
  const int size = 1201;
  const auto height = [](double column, double row) { return 0.3 * column - 0.2 * row; };
  const std::string file = ::testing::TempDir() + "lsos_look_overviews.tif";
  GDALAllRegister();
  const auto write = [&](bool has_overviews) {
    GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), size, size, 1, GDT_Float32, nullptr));
    double transform[] = {-1201, 2, 0, 1201, 0, -2};
    dataset->SetGeoTransform(transform);
    OGRSpatialReference crs;
    crs.importFromProj4("+proj=eqc +R=1737400 +units=m");
    dataset->SetSpatialRef(&crs);
    std::vector<float> row(size);
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) row[i] = static_cast<float>(height(i, j));
      EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, j, size, 1, row.data(), size, 1,
                                                    GDT_Float32, 0, 0),
                CE_None);
    }
    const int factors[] = {2, 4, 8};
    if (has_overviews) {
      EXPECT_EQ(dataset->BuildOverviews("AVERAGE", 3, factors, 0, nullptr, nullptr, nullptr),
                CE_None);
    }
  };
  for (const bool has_overviews : {false, true}) {
    write(has_overviews);
    const Ground ground(raster_terrain(file), site_on("Moon", 0, 0), 0);
    for (const double resolution_m : {4.0, 8.0, 16.0, 32.0}) {
      Ground::Probe far(ground, resolution_m), close(ground);
      double before_m = 0;
      for (double x = -1100; x < 1100; x += 0.5) {
        const double apart_m =
            far.sample({x, 3, 0}).elevation_m - close.sample({x, 3, 0}).elevation_m;
        // The point lies at most half a level's cell off: 16 m on a slope of 0.18.
        EXPECT_LT(std::abs(apart_m), 0.1 * resolution_m) << resolution_m << " " << x;
        if (x > -1100) {
          ASSERT_NEAR(apart_m, before_m, 0.005) << resolution_m << " " << x;
        }
        before_m = apart_m;
      }
    }
  }
}

// A crater as large as the resolution is there, wherever grid and detail share the work.
TEST(Look, at_a_relief_has_all_that_is_as_large_as_the_resolution) {
  TerrainSpec spec;
  ReliefSurface relief;
  relief.spacing_m = 16;
  spec.layers = {relief};
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->exponent = 2;
  spec.detail->craters->density_pm2 = 2e-5;
  spec.detail->craters->depth_to_diameter = 0.2;
  for (const double diameter_m : {180.0, 250.0, 380.0}) {
    spec.detail->craters->diameter_min_m = diameter_m;
    spec.detail->craters->diameter_max_m = 1.01 * diameter_m;
    const Ground ground(spec, site_on("Moon", 0, 0), 7);
    const Difference d = difference(ground, 150, 10000);
    EXPECT_GT(d.relief_m, 0.5);
    EXPECT_LT(d.rms_m, 0.6 * d.relief_m) << diameter_m;
  }
}

TEST(Look, at_a_relief_leaves_out_small_craters) {
  TerrainSpec spec;
  ReliefSurface relief;
  relief.spacing_m = 16;
  relief.landforms = {{"bowl", 0, 0, 20000, 3000, 500}};
  spec.layers = {relief};
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.5;
  spec.detail->craters->diameter_min_m = 5;
  spec.detail->craters->diameter_max_m = 2000;
  const Ground ground(spec, site_on("Moon", 0, 0), 7);
  const Difference d = difference(ground, 512, 15000);
  EXPECT_LT(d.rms_m, 0.03 * d.relief_m);
  EXPECT_GT(d.rms_m, 0.1);
}

TEST(Look, at_detail_leaves_out_what_is_small) {
  TerrainSpec spec = plane_terrain(0);
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.5;
  spec.detail->craters->diameter_min_m = 1;
  spec.detail->craters->diameter_max_m = 100;
  spec.detail->roughness = Roughness{0.03, 0.7, 16};
  spec.detail->rocks = RockPopulation{0.05, 0.2, 3, 0.5};
  const Ground ground(spec, site_on("Moon", 0, 0), 7);
  for (const double resolution_m : {8.0, 16.0, 32.0, 64.0}) {
    const Difference d = difference(ground, resolution_m, 400);
    EXPECT_LT(d.rms_m, 0.01 * resolution_m) << resolution_m;
    EXPECT_LT(d.rms_m, 0.5 * d.relief_m) << resolution_m;
    EXPECT_GT(d.rms_m, 0.0003 * resolution_m) << resolution_m;
  }
}

// Wide cells over small craters and dense rocks: what lies between the sampled nodes is not
// computed, or this would take gigabytes and hours.
TEST(Look, at_wide_cells_with_small_craters_ends) {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-7200,900,0,7200,0,-900", "",
                          rows_of(16, 16, [](int column, int) { return 10.0 * column; })};
  const TerrainSpec bare = raster_terrain(raster.write("wide"));
  TerrainSpec spec = bare;
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.9;
  spec.detail->craters->diameter_min_m = 0.5;
  spec.detail->craters->diameter_max_m = 3000;
  spec.detail->rocks = RockPopulation{0.1, 0.1, 4, 0.5};
  const SiteFrame site = site_on("Moon", 0, 0);
  const Ground ground(spec, site, 7), plain(bare, site, 7);
  Ground::Probe probe(ground, 100), plain_probe(plain, 100);
  EXPECT_GT(
      std::abs(probe.sample({0, 0, 0}).elevation_m - plain_probe.sample({0, 0, 0}).elevation_m),
      0.01);
}

struct Heavy {
  std::size_t bytes() const { return megabytes(1); }
};

TEST(KeyCache, keeps_at_most_twice_its_bytes) {
  KeyCache<int, Heavy> cache(megabytes(4));
  std::vector<std::weak_ptr<const Heavy>> all;
  for (int k = 0; k < 50; ++k) all.push_back(cache.get(k, [](int) { return Heavy{}; }));
  const auto alive = std::ranges::count_if(all, [](const auto& p) { return !p.expired(); });
  EXPECT_GE(alive, 4);
  EXPECT_LE(alive, 9);
}

}  // namespace
}  // namespace lsos
