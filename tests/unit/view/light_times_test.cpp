#include "view/exposure/light_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planet/sunlight.h"
#include "unit/view/view_fixture.h"
#include "view/exposure/ground_light.h"

namespace lsos {
namespace {

using test::deg;

Instant utc(const char* text) { return *parse_utc(text).value; }

TEST(SunMoments, cover_the_span_and_the_last_is_cut) {
  const auto moments =
      sun_moments(utc("2026-07-01T00:00:00Z"), utc("2026-07-01T02:30:00Z"), from_seconds(3600));
  ASSERT_EQ(moments.size(), 3u);
  EXPECT_EQ(moments[1].at, utc("2026-07-01T01:00:00Z"));
  EXPECT_EQ(moments[0].lasts_s, 3600);
  EXPECT_EQ(moments[2].lasts_s, 1800);
}

// A month in and beside a crater near the pole, against the disc marched at each moment.
TEST(LightTimes, agree_with_light_at_each_moment) {
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(0, -88));
  TerrainSpec spec;
  ReliefSurface relief;
  relief.lat_rad = -88 * deg;
  relief.landforms = {{"bowl", 0, -88 * deg, 3000, 90, 20},
                      {"hill", 10 * deg, -87.9 * deg, 2500, 0, 120}};
  spec.layers = {relief};
  const Ground ground(spec, site, 1);
  const auto moments =
      sun_moments(utc("2026-07-01T00:00:00Z"), utc("2026-07-29T00:00:00Z"), from_seconds(6 * 3600));
  LightTimesProbe times(ground, 20, moments);
  GroundLightProbe light(ground, 20);
  int partly = 0;
  for (const double north_m : {-1000.0, 0.0, 1200.0, 2500.0}) {
    const Geodetic place = site.geodetic({200, north_m, 0});
    double mean = 0, dark_s = 0, longest_dark_s = 0;
    for (const SunMoment& moment : moments) {
      const Sunlight sun = sunlight(site.body(), place, moment.at, 0);
      const Vec3 sun_S = direction_S(site, site.p_S_m(place), sun.seen);
      const double share = light.at(place, sun_S, sun.disc_rad)->sun_fraction * (1 - sun.eclipsed);
      mean += share / static_cast<double>(moments.size());
      dark_s = share > 0 ? 0 : dark_s + moment.lasts_s;
      longest_dark_s = std::max(longest_dark_s, dark_s);
    }
    partly += mean > 0.02 && mean < 0.98;
    const LightTimes found = *times.at(place);
    EXPECT_NEAR(found.mean_fraction, mean, 0.005) << north_m;
    EXPECT_NEAR(found.longest_dark_s, longest_dark_s, 6 * 3600) << north_m;
    EXPECT_FALSE(found.end) << north_m;
    // An eye high over the ground is not asked for: dark and lit share out the month.
    EXPECT_LE(found.longest_lit_s + found.longest_dark_s, 28 * 86400) << north_m;
  }
  EXPECT_GE(partly, 2);
}

}  // namespace
}  // namespace lsos
