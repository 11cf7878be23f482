// Looks from afar: what is much smaller than the resolution is left out, the rest stays.
#include <cmath>
#include <numbers>

#include "ground_fixture.h"
#include "terrain/key_cache.h"

namespace lsos {
namespace {

// RMS of the difference between a look from afar and one from close by, and of the latter about its
// mean, over points on a circle of that radius.
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

TEST(Look, goes_around_the_body) {
  const TextRaster raster{"+proj=longlat +R=1737400", "-180,1,0,90,0,-1", "",
                          rows_of(360, 180, [](int column, int) {
                            return 1000 * std::sin(column * std::numbers::pi / 180);
                          })};
  const Ground ground(raster_terrain(raster.write("globe")), site_on("Moon", 180, 0), 0);
  const double cell_m = 1737400 * std::numbers::pi / 180;
  for (double lon_deg = 170; lon_deg < 190; lon_deg += 0.37) {
    const Geodetic place = geodetic_from_degrees(lon_deg, 3);
    // Half a degree beside the middle of four, at 17.5 m a degree.
    EXPECT_NEAR(*ground.elevation_m(place, 4 * cell_m), *ground.elevation_m(place), 10) << lon_deg;
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

// Raster cells of 1 km over small craters and dense rocks: what lies between the nodes looked at is
// not made, or this would take gigabytes.
TEST(Look, at_wide_cells_with_small_craters_ends) {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-8000,1000,0,8000,0,-1000", "",
                          rows_of(16, 16, [](int column, int) { return 10.0 * column; })};
  TerrainSpec spec = raster_terrain(raster.write("wide"));
  spec.detail.emplace();
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.9;
  spec.detail->craters->diameter_min_m = 0.5;
  spec.detail->craters->diameter_max_m = 3000;
  const Ground ground(spec, site_on("Moon", 0, 0), 7);
  Ground::Probe probe(ground, 100);
  EXPECT_TRUE(probe.sample({0, 0, 0}).is_ground());
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
