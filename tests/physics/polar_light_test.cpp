// Light on the shipped ground of the Moon's south pole, by marching over it, as maps do, and by
// rendering, as for panels. The two methods share no code but the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "mission/light/light.h"
#include "mission/model/site.h"
#include "physics/drive.h"
#include "view/exposure/ground_light.h"

namespace lsos::test {
namespace {

class PolarLight : public ::testing::Test {
 protected:
  double sun_fraction(GroundLightProbe& probe, const Geodetic& place, Instant at,
                      double height_m = 0) const {
    const Sunlight sun = sunlight(moon, place, at, 0);
    const Vec3 sun_S = direction_S(ground->site(), ground->site().p_S_m(place), sun.seen);
    return probe.at(place, sun_S, sun.disc_rad, height_m)->sun_fraction;
  }

  const Body& moon = *find_body("Moon");
  const Geodetic site = geodetic_from_degrees(129.78, -89.67);  // Shackleton
  std::unique_ptr<Ground> ground = ground_at(shipped_terrain("LunarSouthPole"), moon, site, 1);
};

std::vector<Instant> sampled_dates(const std::vector<std::string>& dates) {
  std::vector<Instant> moments;
  for (const std::string& date : dates) moments.push_back(*parse_utc(date).value);
  return moments;
}

// Over a year, at all phases of the Moon, mapped permanent shadow (Mazarico et al. 2011) stays
// dark, and Shackleton's rim is lit most of the time.
TEST_F(PolarLight, never_comes_to_the_floors_of_the_cold_traps) {
  const auto dates =
      sampled_dates({"2026-01-10", "2026-02-23", "2026-03-27", "2026-05-03", "2026-06-07",
                     "2026-07-22", "2026-08-30", "2026-10-14", "2026-11-11", "2026-12-20"});
  struct Floor {
    const char* crater;
    double lon_deg, lat_deg;
  };
  GroundLightProbe probe(*ground, 100);
  for (const Floor& floor : {Floor{"Shackleton", 129.78, -89.67}, Floor{"Shoemaker", 45.91, -88.14},
                             Floor{"Faustini", 84.31, -87.18}, Floor{"Haworth", -5.17, -87.45},
                             Floor{"Sverdrup", -152.1, -88.3}}) {
    for (const Instant at : dates) {
      const auto place = geodetic_from_degrees(floor.lon_deg, floor.lat_deg);
      EXPECT_EQ(sun_fraction(probe, place, at), 0) << floor.crater << " " << format_utc(at);
    }
  }
  // Eight places on the rim, 10.5 km from the crater's centre.
  int lit = 0, seen = 0;
  for (const Instant at : dates) {
    double most = 0;
    for (int k = 0; k < 8; ++k) {
      const double azimuth = k * std::numbers::pi / 4;
      const Vec3 on_rim_S(10500 * std::sin(azimuth), 10500 * std::cos(azimuth), 0);
      most = std::max(most, sun_fraction(probe, ground->site().geodetic(on_rim_S), at));
    }
    lit += most > 0.2;
    ++seen;
  }
  std::printf("some of Shackleton's rim is lit on %d of %d dates\n", lit, seen);
  EXPECT_GT(lit, seen / 2);
}

// A small square above the ground facing the Sun, rendered, against the same place marched: random
// places and times, with the Sun near the horizon.
TEST_F(PolarLight, is_the_same_drawn_and_marched) {
  Renderer renderer;
  Light light(*ground, renderer);
  GroundLightProbe probe(*ground, 0.2);
  constexpr double height_m = 1.5;
  RandomStream random(3);
  double sum = 0, worst = 0, partly = 0;
  constexpr int count = 40;
  for (int k = 0; k < count; ++k) {
    const Vec3 about_S(random.uniform(-14e3, 14e3), random.uniform(-14e3, 14e3), 0);
    const Geodetic place = ground->site().geodetic(about_S);
    const Instant at{parse_utc("2026-10-01").value->tai_us +
                     static_cast<std::int64_t>(random.uniform(0, 60 * 86400e6))};
    const double elevation_m = *ground->elevation_m(place);
    const Vec3 eye_S_m =
        ground->site().p_S_m({place.lon_rad, place.lat_rad, elevation_m + height_m});
    const Sunlight sun = sunlight(moon, ground->site().geodetic(eye_S_m), at, 0);
    const Vec3 sun_S = direction_S(ground->site(), eye_S_m, sun.seen);
    const Vec3 u = sun_S.unitOrthogonal() * 0.005;
    const double drawn =
        light.sun_fractions({eye_S_m, {{{0, 0, 0}, u, sun_S.cross(u)}}, {}}, sun)[0];
    const double marched = sun_fraction(probe, place, at, height_m);
    sum += std::abs(drawn - marched);
    worst = std::max(worst, std::abs(drawn - marched));
    partly += marched > 0.05 && marched < 0.95;
  }
  std::printf(
      "drawn and marched differ by %.4f of the disc in the mean, %.4f at most; %.0f of %d "
      "places saw part of it\n",
      sum / count, worst, partly, count);
  EXPECT_LT(sum / count, 0.02);
}

}  // namespace
}  // namespace lsos::test
