// Terrains that end, with others laid around them.
#include "terrain/spec/terrain_beyond.h"

#include <cmath>

#include "ground_fixture.h"

namespace lsos {
namespace {

// 400 m across, in cells of 4 m.
std::string fine_file() {
  return TextRaster{"+proj=eqc +R=1737400 +units=m", "-200,4,0,200,0,-4", "",
                    rows_of(100, 100, [](int column, int row) { return 0.1 * column + 0.2 * row; })}
      .write("fine");
}

TerrainSpec rough(const char* name) {
  TerrainSpec spec;
  spec.name = name;
  spec.planet = "Moon";
  spec.layers = {PlaneSurface{}};
  spec.detail = Detail{};
  spec.detail->roughness = Roughness{0.05, 0.7, 16};
  spec.soil.name = "Dust";
  spec.optical_depth = 0.3;
  return spec;
}

TEST(TerrainBeyond, leaves_a_raster_as_it_is_and_has_its_own_detail) {
  const TerrainSpec raster = raster_terrain(RasterSurface{fine_file()}, {"plan.kml", 4});
  const TerrainSpec both = with_beyond(raster, rough("Rough"));
  EXPECT_EQ(both.name, "fine.vrt");
  EXPECT_EQ(both.beyond->name, "Rough");
  EXPECT_EQ(both.planet, "Moon");
  EXPECT_EQ(both.soil.name, "Dust");
  EXPECT_EQ(both.optical_depth, 0.3);
  const SiteFrame site = site_on("Moon", 0, 0);
  const Ground alone(raster, site, 1), over(both, site, 1);
  Ground::Probe of_alone(alone), of_over(over);
  double roughest_m = 0;
  for (double x = 0; x < 400; x += 7.3) {
    const double height_m = of_over.sample({x, 20, 0}).elevation_m;
    if (x < 60) {
      EXPECT_EQ(height_m, of_alone.sample({x, 20, 0}).elevation_m) << x;
    } else if (x > 200) {
      roughest_m = std::max(roughest_m, std::abs(height_m));
    }
  }
  EXPECT_GT(roughest_m, 0.01);
  EXPECT_LT(roughest_m, 2);
  EXPECT_NE(alone.hash(), over.hash());
  EXPECT_TRUE(alone.has_end());
  EXPECT_FALSE(over.has_end());
}

TEST(TerrainBeyond, keeps_what_a_script_says) {
  TerrainSpec script = raster_terrain(RasterSurface{fine_file()}, {});
  script.soil.name = "Ours";
  script.detail = Detail{};
  const TerrainSpec both = with_beyond(script, rough("Rough"));
  EXPECT_EQ(both.soil.name, "Ours");
  EXPECT_FALSE(both.optical_depth);
  EXPECT_FALSE(both.detail->roughness);
  EXPECT_FALSE(both.beyond->has_detail_alone);
}

// The raster itself gets no craters; those are the other terrain's own.
TEST(TerrainBeyond, is_not_said_to_add_no_craters_to_the_raster) {
  TerrainSpec cratered = rough("Cratered");
  cratered.detail->craters.emplace().diameter_min_m = 10;
  const TerrainSpec raster = raster_terrain(RasterSurface{fine_file()}, {});
  EXPECT_EQ(Ground(with_beyond(raster, cratered), site_on("Moon", 0, 0), 0).advice().size(), 0u);
  TerrainSpec script = raster;
  script.detail = cratered.detail;
  const auto advice = Ground(script, site_on("Moon", 0, 0), 0).advice();
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_THAT(advice[0].what, ::testing::HasSubstr("detail adds no craters"));
}

TEST(TerrainBeyond, is_refused_where_nothing_of_it_could_lie) {
  const TerrainSpec raster = raster_terrain(RasterSurface{fine_file()}, {});
  EXPECT_THROW(with_beyond(rough("Rough"), raster), InputError);
  TerrainSpec mars = rough("Dunes"), moon = raster;
  mars.planet = "Mars";
  moon.planet = "Moon";
  EXPECT_THROW(with_beyond(moon, mars), InputError);
  // The same raster ends at the same edge.
  const TerrainSpec twice = with_beyond(raster, raster);
  EXPECT_THROW(Ground(twice, site_on("Moon", 0, 0), 0), InputError);
}

}  // namespace
}  // namespace lsos
