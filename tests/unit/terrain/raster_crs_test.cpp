#include <cmath>

#include "ground_fixture.h"

namespace lsos {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const std::string& file, const SiteFrame& site, int band = 1) {
  try {
    const Ground ground(raster_terrain(file, band), site, 0);
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults()[0].place, (Place{"terrain/x.lua", 3}));
    return error.what();
  }
  return "accepted";
}

const std::vector<std::vector<double>> ramp =
    rows_of(40, 30, [](int column, int row) { return 100 + 2.0 * column - 0.5 * row; });

// Geotransform of a raster of 1 m around the origin of a projection centred at the site.
constexpr char centred_moon[] = "+proj=laea +lat_0=20 +lon_0=-30 +R=1737400 +units=m";
constexpr char centred_transform[] = "-20, 1, 0, 15, 0, -1";

TEST(RasterErrors, name_the_file_and_the_reason) {
  const SiteFrame moon = site_on("Moon", -30, 20);
  EXPECT_THAT(refusal("no/such.tif", moon),
              AllOf(HasSubstr("terrain/x.lua:3: raster 'no/such.tif' cannot be opened: "),
                    HasSubstr("No such file")));
  const std::string good = TextRaster{centred_moon, centred_transform, "", ramp}.write("good");
  EXPECT_EQ(refusal(good, moon), "accepted");
  EXPECT_THAT(refusal(good, moon, 2), HasSubstr("has no band 2: 1..1 is allowed"));
  EXPECT_THAT(refusal(good, moon, 0), HasSubstr("has no band 0"));
  EXPECT_THAT(refusal(TextRaster{"", centred_transform, "", ramp}.write("nocrs"), moon),
              HasSubstr("has no coordinate reference system"));
  EXPECT_THAT(refusal(TextRaster{centred_moon, "", "", ramp}.write("nogt"), moon),
              HasSubstr("has no geotransform"));
  EXPECT_THAT(
      refusal(TextRaster{centred_moon, centred_transform, "", {{1, 2, 3}}}.write("thin"), moon),
      HasSubstr("has 3 x 1 cells; at least 2 x 2 are needed"));
  EXPECT_THAT(
      refusal(TextRaster{"LOCAL_CS[\"x\",UNIT[\"metre\",1]]", centred_transform, "", ramp}.write(
                  "local"),
              moon),
      HasSubstr("tied to no body"));
}

TEST(RasterErrors, name_the_file_whose_samples_cannot_be_read) {
  const std::string file = TextRaster{centred_moon, centred_transform, "", ramp}.write("gone");
  // The virtual raster stays, the grid behind it is deleted.
  std::filesystem::remove(file.substr(0, file.size() - 3) + "asc");
  EXPECT_THAT(refusal(file, site_on("Moon", -30, 20)),
              AllOf(HasSubstr("raster '" + file + "' cannot be read: "), HasSubstr("gone.asc")));
}

TEST(RasterErrors, name_both_bodies) {
  const std::string mars =
      TextRaster{"IAU_2015:49900", "-30.001, 0.0001, 0, 20.001, 0, -0.0001", "", ramp}.write(
          "mars");
  EXPECT_THAT(refusal(mars, site_on("Moon", -30, 20)),
              HasSubstr("lies on Mars (semi-major axis 3396190 m), the site on Moon (1737400 m)"));
  EXPECT_THAT(refusal(mars, site_on("Earth", -30, 20)), HasSubstr("lies on Mars"));
  EXPECT_EQ(refusal(mars, site_on("Mars", -30, 20)), "accepted");
  const std::string phobos =
      TextRaster{"+proj=eqc +R=11100", centred_transform, "", ramp}.write("phobos");
  EXPECT_THAT(refusal(phobos, site_on("Mars", 0, 0)),
              HasSubstr("lies on another body (semi-major axis 11100 m), the site on Mars"));
}

// The centre of the raster at (lon, lat) in each CRS must be found at that place.
TEST(RasterCrs, a_slightly_different_sphere_is_entered_by_longitude_and_latitude) {
  const std::string other = "+proj=laea +lat_0=20 +lon_0=-30 +R=1738000 +units=m";
  const Ground ground(raster_terrain(TextRaster{other, centred_transform, "", ramp}.write("r")),
                      site_on("Moon", -30, 20), 0);
  // The point lies 10 m east on the larger sphere.
  const double lon_deg = -30 + 10 / (1738000 * std::cos(20 * M_PI / 180)) * 180 / M_PI;
  EXPECT_NEAR(*ground.elevation_m(geodetic_from_degrees(lon_deg, 20)), 100 + 2 * 29.5 - 0.5 * 14.5,
              1e-5);
}

TEST(RasterCrs, longitudes_may_count_from_0_to_360) {
  // 20 columns of 0.01 degrees from 329.9 on: the site's -30 degrees are 330.
  const Ground ground(
      raster_terrain(
          TextRaster{"IAU_2015:30100", "329.9, 0.01, 0, 20.1, 0, -0.01", "", ramp}.write("r")),
      site_on("Moon", -30, 20), 0);
  const Geodetic place = geodetic_from_degrees(-30, 20);
  EXPECT_NEAR(*ground.elevation_m(place), 100 + 2 * 9.5 - 0.5 * 9.5, 1e-6);
  Ground::Probe probe(ground);
  EXPECT_NEAR(probe.sample(Vec3::Zero()).elevation_m, 100 + 2 * 9.5 - 0.5 * 9.5, 1e-6);
}

TEST(RasterCrs, a_projection_may_run_past_its_own_longitude_range) {
  // Equidistant cylindrical about longitude 0, yet 0..360: the x of 330 degrees.
  const double metre_per_deg = 1737400 * M_PI / 180;
  TextRaster raster{"+proj=eqc +R=1737400", "", "", ramp};
  raster.geotransform = std::to_string(330 * metre_per_deg - 10) + ", 1, 0, " +
                        std::to_string(20 * metre_per_deg + 10) + ", 0, -1";
  const Ground ground(raster_terrain(raster.write("r")), site_on("Moon", -30, 20), 0);
  EXPECT_NEAR(*ground.elevation_m(geodetic_from_degrees(-30, 20)), 100 + 2 * 9.5 - 0.5 * 9.5, 1e-4);
}

TEST(RasterCrs, a_raster_around_the_body_has_no_seam) {
  // 36 x 18 cells of 10 degrees, smooth in longitude, with the seam at longitude 0.
  const auto rows = rows_of(
      36, 18, [](int column, int) { return 1000 * std::sin((column + 0.5) * 10 * M_PI / 180); });
  const Ground ground(
      raster_terrain(TextRaster{"IAU_2015:30100", "0, 10, 0, 90, 0, -10", "", rows}.write("r")),
      site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  const GroundSample west = probe.sample({-1e-3, 0, 0});
  const GroundSample east = probe.sample({1e-3, 0, 0});
  EXPECT_NEAR(west.elevation_m, 0, 1e-3);
  EXPECT_NEAR(west.elevation_m, east.elevation_m, 1e-5);
  EXPECT_LT((west.normal_S - east.normal_S).norm(), 1e-8);
  // The ground rises eastwards by 1000 m per radian of longitude, but for interpolation.
  EXPECT_NEAR(-east.normal_S.x() / east.normal_S.z(), 1000 / 1737400.0, 1e-5);
}

TEST(RasterCrs, planetographic_latitudes_of_mars_are_converted) {
  // On the ellipsoid of IAU 2015, at planetocentric 45 degrees: tan(graphic) = tan / (1 - f)^2.
  const double flattening = 1 / 169.894447223612;
  const double graphic_deg = std::atan(1 / ((1 - flattening) * (1 - flattening))) * 180 / M_PI;
  TextRaster raster{"+proj=longlat +a=3396190 +rf=169.894447223612", "", "", ramp};
  raster.geotransform = "9.9, 0.01, 0, " + std::to_string(graphic_deg + 0.1) + ", 0, -0.01";
  const Ground ground(raster_terrain(raster.write("r")), site_on("Mars", 10, 45), 0);
  EXPECT_NEAR(*ground.elevation_m(geodetic_from_degrees(10, 45)), 100 + 2 * 9.5 - 0.5 * 9.5, 1e-3);
}

TEST(RasterCrs, west_longitudes_and_planetocentric_axes_are_understood) {
  const double flattening = 1 / 169.894447223612;
  const double graphic_rad = std::atan(std::tan(M_PI / 4) / ((1 - flattening) * (1 - flattening)));
  const double metre_per_rad = 3396190;
  // Equirectangular of the planetographic latitude; 49911 counts west, 49912 east, and both take
  // the meridian's length from the equatorial radius within the ellipsoid's meridian arc.
  for (const char* crs : {"IAU_2015:49911", "IAU_2015:49912"}) {
    const double sign = std::string(crs) == "IAU_2015:49911" ? -1 : 1;
    TextRaster raster{crs, "", "", ramp};
    raster.geotransform = std::to_string(sign * metre_per_rad * 10 * M_PI / 180 - 20) + ", 1, 0, " +
                          std::to_string(metre_per_rad * graphic_rad + 15) + ", 0, -1";
    const Ground ground(raster_terrain(raster.write("r" + std::string(crs).substr(9))),
                        site_on("Mars", 10, 45), 0);
    const auto elevation_m = ground.elevation_m(geodetic_from_degrees(10, 45));
    ASSERT_TRUE(elevation_m) << crs;
    EXPECT_NEAR(*elevation_m, 100 + 2 * 19.5 - 0.5 * 14.5, 1e-3) << crs;
  }
}

TEST(RasterCrs, a_rotated_raster_is_read_along_its_own_axes) {
  // Columns run north, rows run east.
  const Ground ground(
      raster_terrain(TextRaster{centred_moon, "-15, 0, 1, -20, 1, 0", "", ramp}.write("r")),
      site_on("Moon", -30, 20), 0);
  Ground::Probe probe(ground);
  const GroundSample here = probe.sample(Vec3::Zero());
  EXPECT_NEAR(here.elevation_m, 100 + 2 * 19.5 - 0.5 * 14.5, 1e-5);
  // A metre of the map is a little more than a metre at that height.
  const double stretch = 1 + here.elevation_m / 1737400;
  EXPECT_NEAR(-here.normal_S.y() / here.normal_S.z(), 2 / stretch, 1e-7);
  EXPECT_NEAR(-here.normal_S.x() / here.normal_S.z(), -0.5 / stretch, 1e-7);
}

TEST(RasterCrs, a_geographic_raster_works_at_the_pole) {
  // 1 degree of longitude by 1e-4 degrees of latitude (3 m); a cone that rises 1 m per row.
  const auto rows = rows_of(360, 50, [](int, int row) { return 500.0 - row; });
  const Ground ground(
      raster_terrain(
          TextRaster{"IAU_2015:30100", "-180, 1, 0, -89.995, 0, -0.0001", "", rows}.write("r")),
      site_on("Moon", 0, -90), 0);
  Ground::Probe probe(ground);
  const double row_m = 1e-4 * M_PI / 180 * 1737400;
  for (double x : {-40.0, 20.1, 60.0}) {
    for (double y : {-30.0, 35.5}) {
      const double row = 49.5 - std::hypot(x, y) / row_m;
      EXPECT_NEAR(probe.sample({x, y, 0}).elevation_m, 500 - row, 1e-3) << x << " " << y;
      const Vec3 p = on_surface(ground, probe, {x, y, 0});
      EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1e-3)).norm(), 1e-4);
    }
  }
}

TEST(RasterCrs, heights_far_above_the_ellipsoid_of_earth_stay_over_their_place) {
  const Ground ground(
      raster_terrain(TextRaster{"EPSG:32610", "582678, 1, 0, 4141911, 0, -1", "", ramp}.write("r")),
      site_on("Earth", -122.0654, 37.42, 5), 0);
  const auto below = ground.elevation_m(geodetic_from_degrees(-122.0655, 37.42015));
  ASSERT_TRUE(below);
  Ground::Probe probe(ground);
  for (double height_m : {-10000.0, 0.0, 10000.0}) {
    const Geodetic place = geodetic_from_degrees(-122.0655, 37.42015, height_m);
    const Vec3 p = ground.site().p_S_m(place);
    EXPECT_NEAR(probe.sample(p).elevation_m, *below, 1e-6);
    EXPECT_NEAR(probe.sample(p).gap_m, height_m - *below, 1e-6);
  }
  const Vec3 p =
      on_surface(ground, probe, ground.site().p_S_m(geodetic_from_degrees(-122.0655, 37.42015)));
  EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1e-2)).norm(), 1e-6);
}

}  // namespace
}  // namespace lsos
