// Tests where rasters end before the distance up to which ground can matter.
#include "view/ground/ground_end.h"

#include "base/units.h"
#include "unit/terrain/ground_fixture.h"
#include "view/exposure/ground_light.h"
#include "view/ground/horizon_reach.h"

namespace lsos {
namespace {

constexpr double sun_disc_rad = 0.0047;

// 1 km across, about longitude and latitude 0 on the Moon; heights by metres east and north.
template <class Height>
TextRaster kilometre(const Height& height_m, const std::string& band = "") {
  return {"+proj=eqc +R=1737400 +units=m", "-500,10,0,500,0,-10", band,
          rows_of(100, 100, [&](int column, int row) {
            return height_m(10 * column - 495.0, 495.0 - 10 * row);
          })};
}

Ground ground_of(const TextRaster& raster) {
  return {raster_terrain(raster.write("ground")), site_on("Moon", 0, 0), 0};
}

Vec3 direction_of_degrees(double azimuth_deg, double elevation_deg) {
  const double a = radians(azimuth_deg), e = radians(elevation_deg);
  return {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
}

TEST(GroundEnd, is_where_the_raster_is) {
  const Ground ground = ground_of(kilometre([](double, double) { return 0; }));
  GroundEndProbe probe(ground);
  const auto end = probe.towards({0, 0, 2}, direction_of_degrees(0, 5), sun_disc_rad);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->reaches_m, 500, 1);
  EXPECT_NEAR(end->matters_m, horizon_reach_m(ground.site().body(), 2, radians(5) - sun_disc_rad),
              1);
  EXPECT_NEAR(probe.towards({300, 0, 2}, direction_of_degrees(90, 5), sun_disc_rad)->reaches_m, 200,
              1);
  EXPECT_FALSE(probe.towards({0, 0, 2}, direction_of_degrees(0, 45), sun_disc_rad));
  EXPECT_FALSE(probe.towards({0, 0, 2}, direction_of_degrees(0, 90), sun_disc_rad));
}

TEST(GroundEnd, does_not_count_behind_ground_that_hides_all) {
  const Ground ground =
      ground_of(kilometre([](double, double north_m) { return north_m > 300 ? 60 : 0; }));
  GroundEndProbe probe(ground);
  EXPECT_FALSE(probe.towards({0, 0, 2}, direction_of_degrees(0, 5), sun_disc_rad));
  EXPECT_TRUE(probe.towards({0, 0, 2}, direction_of_degrees(0, 15), sun_disc_rad));
  EXPECT_TRUE(probe.towards({0, 0, 2}, direction_of_degrees(180, 5), sun_disc_rad));
}

TEST(GroundEnd, is_at_a_hole_too) {
  const Ground ground = ground_of(
      kilometre([](double, double north_m) { return std::abs(north_m - 200) < 40 ? -9999 : 0; },
                "<NoDataValue>-9999</NoDataValue>"));
  GroundEndProbe probe(ground);
  EXPECT_NEAR(probe.towards({0, 0, 2}, direction_of_degrees(0, 5), sun_disc_rad)->reaches_m, 150,
              12);
  const auto across = probe.between({0, 0, 2}, {0, 400, 2});
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->reaches_m, 150, 12);
  EXPECT_FALSE(probe.between({0, 0, 2}, {0, -400, 2}));
  EXPECT_FALSE(probe.between({0, 0, 2}, {0, 100, 2}));
  // Far above all ground that may stand there.
  EXPECT_FALSE(probe.between({0, 0, 2}, {0, 400, 4000}));
}

TEST(GroundEnd, is_nowhere_on_generated_ground_or_over_it) {
  const Ground plane(plane_terrain(0), site_on("Moon", 0, 0), 0);
  EXPECT_FALSE(GroundEndProbe(plane).towards({0, 0, 2}, direction_of_degrees(0, 1), sun_disc_rad));
  TerrainSpec spec = raster_terrain(kilometre([](double, double) { return 0; }).write("fine"));
  spec.layers.emplace_back(PlaneSurface{});
  const Ground over(spec, site_on("Moon", 0, 0), 0);
  EXPECT_FALSE(GroundEndProbe(over).towards({0, 0, 2}, direction_of_degrees(0, 1), sun_disc_rad));
}

// Level ground of that many degrees east of -180.
Ground degrees_of_moon(int columns) {
  const TextRaster raster{"+proj=longlat +R=1737400", "-180,1,0,90,0,-1", "",
                          rows_of(columns, 180, [](int, int) { return 0; })};
  return ground_of(raster);
}

// A raster that covers the body continues beyond the reach of the site.
TEST(GroundEnd, is_not_where_the_reach_of_the_site_ends) {
  for (const bool has_end : {false, true}) {
    const Ground ground = degrees_of_moon(has_end ? 238 : 360);
    const SiteFrame& site = ground.site();
    const Geodetic place = geodetic_from_degrees(has_end ? 57.5 : 59.5, 0);
    const Vec3 eye_S_m = site.p_S_m({place.lon_rad, place.lat_rad, 2});
    const Vec3 sun_S =
        std::cos(radians(1)) * site.east_S(eye_S_m) + std::sin(radians(1)) * site.up_S(eye_S_m);
    EXPECT_EQ(GroundEndProbe(ground).towards(eye_S_m, sun_S, sun_disc_rad).has_value(), has_end);
    const auto light = GroundLightProbe(ground, 1000).at(place, sun_S, sun_disc_rad);
    EXPECT_GT(light->sun_fraction, 0.99);
    EXPECT_EQ(light->end.has_value(), has_end);
  }
}

// The body continues beyond the raster's end, so that a hill does not see the Sun through it.
TEST(GroundEnd, night_falls_on_a_hill_of_a_small_raster) {
  const Ground ground = ground_of(kilometre([](double east_m, double north_m) {
    return std::max(0.0, 200 - 0.6 * std::hypot(east_m, north_m));
  }));
  GroundLightProbe light(ground, 10);
  const Geodetic side = geodetic_from_degrees(0, degrees(100 / 1737400.0));
  EXPECT_EQ(light.at(side, direction_of_degrees(0, -20), sun_disc_rad)->sun_fraction, 0);
  const auto day = light.at(side, direction_of_degrees(0, 20), sun_disc_rad);
  EXPECT_NEAR(day->sun_fraction, 1, 1e-9);
  ASSERT_TRUE(day->end);
  EXPECT_NEAR(day->end->reaches_m, 400, 15);
  EXPECT_FALSE(light.at(side, direction_of_degrees(0, 50), sun_disc_rad)->end);
}

}  // namespace
}  // namespace lsos
