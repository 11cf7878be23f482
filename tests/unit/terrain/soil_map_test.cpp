// Which soil lies where.
#include "ground_fixture.h"

namespace lsos {
namespace {

TEST(Soils, refuse_a_corner_out_of_reach) {
  TerrainSpec spec = plane_terrain(0);
  SoilPatch patch;
  patch.lon_lat_deg = {{0, 0}, {80, 0}, {0, 10}};
  spec.soil_patches = {patch};
  EXPECT_THROW(Ground(spec, site_on("Moon", 0, 0), 0), InputError);
}

TEST(Soils, lie_where_the_script_says) {
  TerrainSpec spec = plane_terrain(0);
  spec.soil.name = "own";
  SoilPatch square;
  square.soil.name = "sand";
  square.lon_lat_deg = {{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}};
  const TextRaster classes{"+proj=longlat +R=1737400",
                           "-0.02,0.01,0,0.02,0,-0.01",
                           "",
                           {{1, 2, 1, 2}, {1, 2, 1, 2}, {3, 3, 3, 3}, {1, 1, 1, 1}}};
  SoilPatch by_class;
  by_class.soil.name = "clay";
  by_class.raster = RasterSurface{classes.write("classes"), 1};
  by_class.values = {2, 3};
  spec.soil_patches = {square, by_class};
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  const auto soil_at = [&](double lon_deg, double lat_deg) {
    const Vec3 p = ground.site().p_S_m(geodetic_from_degrees(lon_deg, lat_deg, 1));
    return ground.soils()[static_cast<std::size_t>(probe.sample(p).soil)].name;
  };
  EXPECT_EQ(soil_at(0.005, 0.005), "sand");
  EXPECT_EQ(soil_at(0.015, 0.005), "clay");
  EXPECT_EQ(soil_at(-0.005, -0.005), "clay");
  EXPECT_EQ(soil_at(-0.005, -0.015), "own");
  EXPECT_EQ(soil_at(0.0001, -0.0101), "own");
  EXPECT_EQ(soil_at(0.5, 0.5), "own");
}

// Two classes of 2 in a row would make a missing sample beside them 2 as well if they were heights.
TEST(Soils, are_the_own_one_where_the_class_is_missing) {
  const TextRaster classes{"+proj=longlat +R=1737400",
                           "-0.02,0.01,0,0.02,0,-0.01",
                           "<NoDataValue>255</NoDataValue>",
                           {{2, 2, 255, 2}, {2, 2, 255, 255}, {2, 2, 2, 2}, {2, 2, 2, 2}}};
  TerrainSpec spec = plane_terrain(0);
  spec.soil.name = "own";
  SoilPatch patch;
  patch.soil.name = "clay";
  patch.raster = RasterSurface{classes.write("classes"), 1};
  patch.values = {2};
  spec.soil_patches = {patch};
  const Ground ground(spec, site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  const auto soil_at = [&](double lon_deg, double lat_deg) {
    const Vec3 p = ground.site().p_S_m(geodetic_from_degrees(lon_deg, lat_deg, 1));
    return ground.soils()[static_cast<std::size_t>(probe.sample(p).soil)].name;
  };
  EXPECT_EQ(soil_at(0.005, 0.005), "own");
  EXPECT_EQ(soil_at(0.005, 0.015), "own");
  EXPECT_EQ(soil_at(0.015, 0.005), "own");
  EXPECT_EQ(soil_at(-0.001, 0.005), "clay");
  EXPECT_EQ(soil_at(0.015, 0.015), "clay");
  EXPECT_EQ(soil_at(0.0205, 0.015), "own");
}

// Impossible as heights would be a palette, numbers of any size, a unit that is no length.
TEST(Soils, are_read_from_classes_that_could_be_no_heights) {
  for (const char* band :
       {"<ColorInterp>Palette</ColorInterp>", "<UnitType>class</UnitType>", "<Scale>0</Scale>"}) {
    const TextRaster classes{
        "+proj=longlat +R=1737400",
        "-0.02,0.01,0,0.02,0,-0.01",
        band,
        {{1, 2, 1, 2}, {1, 2, 1, 2}, {-9999, 1, 40000, 1737000}, {1, 1, 1, 1}}};
    TerrainSpec spec = plane_terrain(0);
    spec.soil.name = "own";
    SoilPatch patch;
    patch.soil.name = "clay";
    patch.raster = RasterSurface{classes.write("classes")};
    patch.values = {2, 40000, 1737000};
    spec.soil_patches = {patch};
    const Ground ground(spec, site_on("Moon", 0, 0), 0);
    Ground::Probe probe(ground);
    const auto soil_at = [&](double lon_deg, double lat_deg) {
      const Vec3 p = ground.site().p_S_m(geodetic_from_degrees(lon_deg, lat_deg, 1));
      return ground.soils()[static_cast<std::size_t>(probe.sample(p).soil)].name;
    };
    EXPECT_EQ(soil_at(-0.005, 0.005), "clay") << band;
    EXPECT_EQ(soil_at(0.005, 0.005), "own") << band;
    EXPECT_EQ(soil_at(0.005, -0.005), "clay") << band;
    EXPECT_EQ(soil_at(0.015, -0.005), "clay") << band;
  }
}

}  // namespace
}  // namespace lsos
