// Level of detail of ground in pictures: coarser with distance, without an edge.
#include "view/ground/lod_probes.h"

#include "unit/terrain/ground_fixture.h"

namespace lsos {
namespace {

// Craters and rocks over a level raster of 1 m.
TerrainSpec rough_raster() {
  const TextRaster raster{"+proj=eqc +R=1737400 +units=m", "-60,1,0,60,0,-1", "",
                          rows_of(120, 120, [](int, int) { return 5; })};
  TerrainSpec spec = raster_terrain(raster.write("level"));
  spec.detail = Detail{};
  spec.detail->craters.emplace();
  spec.detail->craters->age_gyr = 3.9;
  spec.detail->craters->diameter_min_m = 0.5;
  spec.detail->rocks = RockPopulation{0.05, 0.2, 1, 0.5};
  return spec;
}

TEST(LodProbes, lets_detail_fade_with_the_resolution) {
  const Ground ground(rough_raster(), site_on("Moon", 0, 0), 3);
  LodProbes ladder(ground);
  double before = 0, first = 0;
  constexpr double ratio = 1.02;
  for (double resolution_m = 0.25; resolution_m < 20; resolution_m *= ratio) {
    double sum = 0;
    for (int k = 0; k < 400; ++k) {
      const Vec3 p_S_m{-20 + 0.1 * k, 0.037 * k, 0};
      const double added_m = ladder.sample(p_S_m, resolution_m).elevation_m - 5;
      const double next_m = ladder.sample(p_S_m, resolution_m * ratio).elevation_m - 5;
      EXPECT_NEAR(added_m, next_m, 0.015);  // of craters up to 0.2 m deep, rocks 0.5 m high
      sum += added_m * added_m;
    }
    const double rms_m = std::sqrt(sum / 400);
    if (first == 0) first = rms_m;
    if (before > 0) {
      EXPECT_LT(std::abs(rms_m - before), 0.05 * first) << resolution_m;
    }
    before = rms_m;
  }
  EXPECT_GT(first, 0.01);
  EXPECT_LT(before, 0.01 * first);
}

}  // namespace
}  // namespace lsos
