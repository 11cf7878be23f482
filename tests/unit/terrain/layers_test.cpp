// Blending of finer layers over coarser ones.
#include <cmath>

#include "ground_fixture.h"

namespace lsos {
namespace {

TEST(Layers, blend_without_a_step) {
  const TextRaster fine{
      "+proj=eqc +R=1737400 +units=m", "-100,2,0,100,0,-2", "",
      rows_of(100, 100, [](int column, int row) { return 50 + 0.3 * column + 0.1 * row; })};
  const TextRaster coarse{"+proj=eqc +R=1737400 +units=m", "-1000,20,0,1000,0,-20", "",
                          rows_of(100, 100, [](int column, int) { return 40 + 0.5 * column; })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.emplace_back(RasterSurface{coarse.write("coarse"), 1});
  const SiteFrame site = site_on("Moon", 0, 0);
  const Ground both(spec, site, 0), only_fine(raster_terrain(fine.write("fine")), site, 0),
      only_coarse(raster_terrain(coarse.write("coarse")), site, 0);
  Ground::Probe probe(both), fine_probe(only_fine), coarse_probe(only_coarse);
  // The fine layer is in the middle, the coarse one outside, with neither step nor kink between.
  EXPECT_EQ(probe.sample({3, 5, 0}).elevation_m, fine_probe.sample({3, 5, 0}).elevation_m);
  EXPECT_EQ(probe.sample({130, 5, 0}).elevation_m, coarse_probe.sample({130, 5, 0}).elevation_m);
  double before_m = probe.sample({20, 5, 0}).elevation_m, slope_before = 0;
  for (double x = 20.05; x < 140; x += 0.05) {
    const double height_m = probe.sample({x, 5, 0}).elevation_m;
    const double slope = (height_m - before_m) / 0.05;
    EXPECT_LT(std::abs(slope), 3) << x;
    if (x > 20.06) {
      EXPECT_LT(std::abs(slope - slope_before), 0.02) << x;
    }
    before_m = height_m;
    slope_before = slope;
    const Vec3 p{x, 5, 0};
    EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1e-3)).norm(), 1e-4) << x;
  }
  EXPECT_FALSE(probe.sample({1200, 5, 0}).is_ground());
}

// The coarse layer has a hole where the fine one fades: the fine one takes over without a step.
TEST(Layers, end_without_a_step_where_the_last_has_a_hole) {
  const char* nodata = "<NoDataValue>-9999</NoDataValue>";
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-100,2,0,100,0,-2", "",
                        rows_of(100, 100, [](int, int) { return 50; })};
  const TextRaster coarse{
      "+proj=eqc +R=1737400 +units=m", "-400,10,0,400,0,-10", nodata,
      rows_of(80, 80, [](int column, int) { return column >= 46 && column < 60 ? -9999 : 40; })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.emplace_back(RasterSurface{coarse.write("coarse"), 1});
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  double before_m = probe.sample({0, 5, 0}).elevation_m;
  EXPECT_NEAR(before_m, 50, 1e-9);
  for (double x = 0.02; x < 99.5; x += 0.02) {
    const double height_m = probe.sample({x, 5, 0}).elevation_m;
    ASSERT_LT(std::abs(height_m - before_m), 0.02) << x;
    before_m = height_m;
  }
  EXPECT_NEAR(before_m, 50, 1e-9);
  EXPECT_FALSE(probe.sample({110, 5, 0}).is_ground());
  EXPECT_NEAR(probe.sample({-300, 5, 0}).elevation_m, 40, 1e-9);
  EXPECT_NEAR(probe.sample({-399, 5, 0}).elevation_m, 40, 1e-9);
}

// Both layers end at the same box: near it the fine one fades out within a few of its cells.
TEST(Layers, end_without_a_step_where_both_end) {
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-100,2,0,100,0,-2", "",
                        rows_of(100, 100, [](int, int) { return 50; })};
  const TextRaster coarse{"+proj=eqc +R=1737400 +units=m", "-100,10,0,100,0,-10", "",
                          rows_of(20, 20, [](int, int) { return 40; })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.emplace_back(RasterSurface{coarse.write("coarse"), 1});
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  double before_m = 50;
  for (double x = 0; x < 99.9; x += 0.02) {
    const double height_m = probe.sample({x, 5, 0}).elevation_m;
    ASSERT_LT(std::abs(height_m - before_m), 0.1) << x;
    ASSERT_LT(height_m, 50.001);
    ASSERT_GT(height_m, 39.999);
    before_m = height_m;
  }
}

TEST(Layers, go_on_as_the_last_one_however_small_that_is) {
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-20,2,0,20,0,-2", "",
                        rows_of(20, 20, [](int, int) { return 50; })};
  const TextRaster coarse{"+proj=eqc +R=1737400 +units=m", "-60,20,0,60,0,-20", "",
                          rows_of(6, 6, [](int, int) { return 40; })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.layers.emplace_back(RasterSurface{coarse.write("coarse"), 1});
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  EXPECT_NEAR(probe.sample({0, 0, 0}).elevation_m, 50, 1e-6);
  EXPECT_NEAR(probe.sample({40, 0, 0}).elevation_m, 40, 1e-6);
}

TEST(Layers, refuse_a_raster_too_small_to_fade) {
  const TextRaster fine{"+proj=eqc +R=1737400 +units=m", "-10,2,0,10,0,-2", "",
                        rows_of(7, 10, [](int, int) { return 50; })};
  TerrainSpec spec = raster_terrain(fine.write("fine"));
  spec.name = "nested";
  spec.layers.emplace_back(PlaneSurface{});
  try {
    const Ground ground(spec, site_on("Moon", 0, 0), 0);
    FAIL() << "is not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("a raster of 7 x 10 cells is too small"));
  }
}

}  // namespace
}  // namespace lsos
