#include "planet/body.h"
#include "planet/ellipsoid.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace lsos {
namespace {

using std::numbers::pi;

const Body& moon() { return *find_body("Moon"); }
const Body& mars() { return *find_body("Mars"); }
const Body& earth() { return *find_body("Earth"); }

TEST(Body, is_found_by_its_exact_name) {
  EXPECT_EQ(moon().equatorial_radius_m, 1737400);
  EXPECT_EQ(mars().equatorial_radius_m, 3396190);
  EXPECT_EQ(earth().equatorial_radius_m, 6378137);
  EXPECT_EQ(find_body("moon"), nullptr);
  EXPECT_EQ(find_body("Venus"), nullptr);
  EXPECT_EQ(all_bodies().size(), 3u);
}

TEST(Body, turns_degrees_into_radians_and_wraps_longitude) {
  const Geodetic place = geodetic_from_degrees(190, -45, 12);
  EXPECT_NEAR(place.lon_rad, -170 * pi / 180, 1e-15);
  EXPECT_NEAR(lon_deg(place), -170, 1e-12);
  EXPECT_NEAR(lat_deg(place), -45, 1e-12);
  EXPECT_EQ(place.height_m, 12);
}

TEST(Body, places_lie_on_the_sphere_where_longitude_and_latitude_say) {
  const Vec3 east = p_F_m(moon(), geodetic_from_degrees(90, 0, 100));
  EXPECT_LT((east - Vec3(0, 1737500, 0)).norm(), 1e-9);
  const Vec3 pole = p_F_m(mars(), geodetic_from_degrees(30, -90, -1000));
  EXPECT_LT((pole - Vec3(0, 0, -3395190)).norm(), 1e-9);
}

TEST(Body, the_wgs84_ellipsoid_is_met_at_known_points) {
  const double b = 6356752.314245179;  // semi-minor axis of WGS84
  EXPECT_LT((p_F_m(earth(), geodetic_from_degrees(0, 90)) - Vec3(0, 0, b)).norm(), 1e-8);
  EXPECT_LT((p_F_m(earth(), geodetic_from_degrees(180, 0, 5)) - Vec3(-6378142, 0, 0)).norm(), 1e-8);
  // Normal radius of curvature at 45 degrees in closed form: a^2 / sqrt((a^2 + b^2) / 2).
  const double a = 6378137;
  const double n = a * a / std::sqrt((a * a + b * b) / 2);
  const Vec3 p = p_F_m(earth(), geodetic_from_degrees(0, 45, 1000));
  EXPECT_NEAR(p.x(), (n + 1000) * std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(p.z(), (n * (b / a) * (b / a) + 1000) * std::sqrt(0.5), 1e-8);
}

TEST(Body, coordinates_come_back_from_body_fixed_ones) {
  for (const Body& body : all_bodies()) {
    for (double lat : {-90.0, -83.9, -30.0, 0.0, 1e-6, 45.0, 89.9999}) {
      for (double lon : {-179.5, -60.0, 0.0, 137.4}) {
        const Geodetic place = geodetic_from_degrees(lon, lat, 2500);
        const Geodetic back = geodetic(body, p_F_m(body, place));
        EXPECT_NEAR(back.lat_rad, place.lat_rad, 1e-12);
        EXPECT_NEAR(back.height_m, 2500, 1e-8);
        // At the pole itself every longitude is right.
        if (lat > -90) {
          EXPECT_NEAR(back.lon_rad, place.lon_rad, 1e-11);
        }
      }
    }
  }
}

TEST(Body, distances_follow_the_great_circle) {
  const Geodetic a = geodetic_from_degrees(0, 0);
  EXPECT_NEAR(surface_distance_m(moon(), a, geodetic_from_degrees(90, 0)), 1737400 * pi / 2, 1e-6);
  EXPECT_NEAR(surface_distance_m(moon(), a, geodetic_from_degrees(180, 0)), 1737400 * pi, 1e-6);
  EXPECT_NEAR(surface_distance_m(moon(), a, geodetic_from_degrees(0, 1e-6)),
              1737400 * 1e-6 * pi / 180, 1e-9);
  EXPECT_EQ(surface_distance_m(moon(), a, a), 0);
}

TEST(Body, distances_on_earth_are_those_of_the_ellipsoid) {
  const Geodetic equator = geodetic_from_degrees(0, 0);
  // The quarter meridian of WGS84 is 10001965.729 m.
  EXPECT_NEAR(surface_distance_m(earth(), equator, geodetic_from_degrees(0, 90)), 10001965.7, 20);
  EXPECT_NEAR(surface_distance_m(earth(), equator, geodetic_from_degrees(10, 0)), 6378137 * pi / 18,
              1e-3);
  // One degree of latitude at the pole: 111694 m (NIMA TR8350.2: 111693.9).
  EXPECT_NEAR(
      surface_distance_m(earth(), geodetic_from_degrees(0, 89), geodetic_from_degrees(0, 90)),
      111693.9, 1);
  EXPECT_EQ(surface_distance_m(earth(), equator, equator), 0);
}

TEST(Gravity, is_that_of_a_point_mass_on_moon_and_mars) {
  EXPECT_NEAR(gravity_mps2(moon(), {}), 1.6242, 1e-4);
  EXPECT_NEAR(gravity_mps2(mars(), {}), 3.7132, 1e-4);
  EXPECT_NEAR(gravity_mps2(moon(), {0, 1, 1737400}), gravity_mps2(moon(), {}) / 4, 1e-12);
}

TEST(Gravity, is_the_normal_gravity_of_wgs84_on_earth) {
  EXPECT_NEAR(gravity_mps2(earth(), {}), 9.7803253359, 1e-10);
  EXPECT_NEAR(gravity_mps2(earth(), geodetic_from_degrees(0, 90)), 9.8321849379, 1e-9);
  // The free-air gradient: 0.3086 mGal a metre.
  const double up = gravity_mps2(earth(), geodetic_from_degrees(0, 45, 1000));
  EXPECT_NEAR(gravity_mps2(earth(), geodetic_from_degrees(0, 45)) - up, 3.086e-3, 2e-6);
}

}  // namespace
}  // namespace lsos
