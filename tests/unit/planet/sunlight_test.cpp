#include "planet/sunlight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"

namespace lsos {
namespace {

double rad(double deg) { return deg * std::numbers::pi / 180; }

// Air mass of an atmosphere that thins out exponentially over a round Earth, summed along the ray:
// a second method, with another model of the air than the formula's.
double air_mass_by_summing(double elevation_rad) {
  constexpr double radius_m = 6371e3, scale_m = 8434, step_m = 20;
  double sum_m = 0;
  for (double s = step_m / 2; s < 2e6; s += step_m) {
    const double r =
        std::sqrt(radius_m * radius_m + s * s + 2 * radius_m * s * std::sin(elevation_rad));
    sum_m += step_m * std::exp(-(r - radius_m) / scale_m);
  }
  return sum_m / scale_m;
}

TEST(Sunlight, is_1361_watts_a_square_metre_at_one_astronomical_unit) {
  EXPECT_DOUBLE_EQ(irradiance_wpm2(149597870700), 1361);
  EXPECT_NEAR(irradiance_wpm2(1.52368 * 149597870700), 586.2, 0.1);  // Mars, mean distance
}

TEST(Sunlight, passes_as_much_air_as_a_sum_along_the_ray_says) {
  EXPECT_NEAR(air_mass(rad(90), 0), 1, 1e-3);
  for (const double elevation_deg : {80., 60., 40., 20., 10.}) {
    const double summed = air_mass_by_summing(rad(elevation_deg));
    EXPECT_NEAR(air_mass(rad(elevation_deg), 0) / summed, 1, 0.01) << elevation_deg;
  }
  EXPECT_NEAR(air_mass(0, 0), 38, 0.5);  // Kasten and Young 1989, table
  EXPECT_NEAR(air_mass(rad(50), 8434) / air_mass(rad(50), 0), std::exp(-1), 1e-12);
}

TEST(Sunlight, grows_weaker_the_more_air_it_passes) {
  double before = 1;
  for (const double elevation_deg : {90., 45., 20., 5., 0.}) {
    const double share = clear_sky_share(rad(elevation_deg), 0);
    EXPECT_LT(share, before);
    before = share;
  }
  EXPECT_NEAR(clear_sky_share(rad(90), 0), 0.7, 1e-3);
  EXPECT_EQ(clear_sky_share(rad(-0.1), 0), 0);
}

TEST(Sunlight, through_dust_follows_beers_law) {
  EXPECT_NEAR(dusty_sky_share(rad(90), 0.5), std::exp(-0.5), 1e-12);
  EXPECT_NEAR(dusty_sky_share(rad(30), 0.5), std::exp(-1), 1e-12);
  EXPECT_EQ(dusty_sky_share(rad(-1), 0.5), 0);
  EXPECT_EQ(dusty_sky_share(rad(-1), 0), 1);
}

// At optical depth 0.65 half of the light on level ground comes from the sky, at 3 nearly all.
TEST(Sunlight, on_mars_comes_from_the_sky_too) {
  const Body& mars = *find_body("Mars");
  const Geodetic place = geodetic_from_degrees(-5.5, -2);
  const Instant noon = *parse_utc("2012-10-17T10:30:00Z").value;
  const auto scattered_share = [&](double optical_depth) {
    const Sunlight light = sunlight(mars, place, noon, optical_depth);
    EXPECT_GT(light.seen.elevation_rad, rad(45));
    const double direct_wpm2 = light.irradiance_wpm2 * std::sin(light.seen.elevation_rad);
    return 1 - direct_wpm2 / level_wpm2(light);
  };
  EXPECT_EQ(scattered_share(0), 0);
  EXPECT_NEAR(scattered_share(0.65), 0.4, 0.1);
  EXPECT_GT(scattered_share(3), 0.9);
  const Sunlight over_bright = sunlight(mars, place, noon, 0.65, 0.4);
  EXPECT_NEAR(over_bright.ground_wpm2, 0.4 * level_wpm2(over_bright), 1e-9);
  EXPECT_GT(over_bright.sky_wpm2, sunlight(mars, place, noon, 0.65).sky_wpm2);
}

TEST(Sunlight, is_none_at_night_from_the_sky_either) {
  for (const char* name : {"Mars", "Earth"}) {
    const Body& body = *find_body(name);
    bool is_any_night = false;
    for (int hour = 0; hour < 24; ++hour) {
      const Instant at = *parse_utc("2026-05-01T00:00:00Z").value + from_seconds(3600. * hour);
      const Sunlight light = sunlight(body, geodetic_from_degrees(10, 5), at, 0.5, 0.3);
      EXPECT_EQ(level_wpm2(light) > 0, light.seen.elevation_rad > 0) << name << hour;
      EXPECT_EQ(light.ground_wpm2 > 0, light.seen.elevation_rad > 0) << name << hour;
      is_any_night |= light.seen.elevation_rad < rad(-20);
    }
    EXPECT_TRUE(is_any_night);
  }
}

TEST(Sunlight, on_the_moon_comes_from_the_sun_and_the_ground_alone) {
  const Body& moon = *find_body("Moon");
  const Geodetic place = geodetic_from_degrees(30, 10);
  const Instant at = *parse_utc("2026-01-01T00:00:00Z").value;
  const Sunlight light = sunlight(moon, place, at, 0, 0.12);
  EXPECT_EQ(light.aureole_wpm2, 0);
  EXPECT_EQ(light.sky_wpm2, 0);
  EXPECT_NEAR(light.ground_wpm2, 0.12 * light.irradiance_wpm2 * std::sin(light.seen.elevation_rad),
              1e-9);
}

TEST(Sunlight, says_what_the_sky_says) {
  const Instant at = *parse_utc("2026-05-01T07:00:00Z").value;
  const Geodetic place = geodetic_from_degrees(-20, -60, 1200);
  for (const char* name : {"Moon", "Mars", "Earth"}) {
    const Body& body = *find_body(name);
    const Sunlight light = sunlight(body, place, at, 0);
    const Sky seen = sky(body, place, at);
    EXPECT_EQ(light.seen.azimuth_rad, seen.sun.azimuth_rad);
    EXPECT_EQ(light.seen.elevation_rad, seen.sun_refracted_rad.value_or(seen.sun.elevation_rad));
    EXPECT_EQ(light.disc_rad, seen.sun_disc_rad);
  }
  const Body& moon = *find_body("Moon");
  const Instant eclipse = *parse_utc("2025-03-14T05:00:00Z").value;
  EXPECT_EQ(sunlight(moon, {}, eclipse, 0).eclipsed, *sky(moon, {}, eclipse).eclipsed);
  EXPECT_GT(sunlight(moon, {}, eclipse, 0).eclipsed, 0);
}

// A direction is found in two ways: by angles in the sky of a place, and in axes fixed to the body.
TEST(Sunlight, comes_from_where_it_is_seen) {
  const Body& moon = *find_body("Moon");
  const Instant at = *parse_utc("2026-05-01T07:00:00Z").value;
  const SiteFrame site(moon, geodetic_from_degrees(12, -89.2));
  RandomStream random(1);
  for (int k = 0; k < 20; ++k) {
    const Geodetic place =
        geodetic_from_degrees(random.uniform(-180, 180), random.uniform(-89.9, -88), 500);
    const Vec3 p_F = p_F_m(moon, place);
    const Vec3 exact_S =
        site.R_FS().transpose() * sighting(moon, p_F, CelestialBody::sun, at).direction_F;
    const Vec3 seen_S = direction_S(site, site.p_S_m(place), sunlight(moon, place, at, 0).seen);
    EXPECT_LT((seen_S - exact_S).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace lsos
