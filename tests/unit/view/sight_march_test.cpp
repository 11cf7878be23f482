// Lines of sight over ground of closed form: the horizon of a sphere, a wall.
#include "view/ground/sight_march.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/view/view_fixture.h"

namespace lsos {
namespace {

using test::deg;

Ground level(const char* body) {
  TerrainSpec spec;
  spec.layers = {PlaneSurface{}};
  return {spec, SiteFrame(*find_body(body), {10 * deg, 20 * deg, 0}), 0};
}

// The point at that distance north of the site along the surface.
Vec3 north_S_m(const Ground& ground, double away_m, double height_m) {
  const double radius_m = ground.site().body().equatorial_radius_m;
  return ground.site().p_S_m({10 * deg, 20 * deg + away_m / radius_m, height_m});
}

// Distance at which two heights just see each other over a smooth sphere, by bisection.
double farthest_m(const Ground& ground, double h1_m, double h2_m) {
  SightMarch march(ground);
  double low_m = 0, high_m = 100e3;
  while (high_m - low_m > 1) {
    const double middle_m = (low_m + high_m) / 2;
    const bool sees = march.sees(north_S_m(ground, 0, h1_m), north_S_m(ground, middle_m, h2_m));
    (sees ? low_m : high_m) = middle_m;
  }
  return low_m;
}

TEST(SightMarch, reaches_to_the_horizons_of_both_ends) {
  // A plane's layer follows the body's curvature: it has one height everywhere.
  for (const char* body : {"Moon", "Mars"}) {
    const Ground ground = level(body);
    const double diameter_m = 2 * ground.site().body().equatorial_radius_m;
    for (const auto& [h1_m, h2_m] : {std::pair{2.0, 2.0}, {2.0, 30.0}, {150.0, 10.0}}) {
      const double expected_m = std::sqrt(diameter_m * h1_m) + std::sqrt(diameter_m * h2_m);
      EXPECT_NEAR(farthest_m(ground, h1_m, h2_m) / expected_m, 1, 0.01) << body << h1_m;
    }
  }
}

// A ridge 300 m high around a bowl, 5 km from its middle.
Ground walled() {
  TerrainSpec spec;
  ReliefSurface relief;
  relief.lon_rad = 10 * deg;
  relief.lat_rad = 20 * deg;
  relief.landforms = {{"bowl", 10 * deg, 20 * deg, 10000, 500, 300}};
  spec.layers = {relief};
  return {spec, SiteFrame(*find_body("Moon"), {10 * deg, 20 * deg, 0}), 0};
}

TEST(SightMarch, is_hidden_by_a_wall_and_free_just_over_it) {
  const Ground ground = walled();
  SightMarch march(ground);
  double crest_m = -1e9;
  Geodetic crest;
  for (double away_m = 3000; away_m < 7000; away_m += 1) {
    const Geodetic place = ground.site().geodetic(north_S_m(ground, away_m, 0));
    const double height_m = ground.elevation_m(place).value();
    if (height_m <= crest_m) continue;
    crest_m = height_m;
    crest = place;
  }
  ASSERT_GT(crest_m, 100);
  // A line from side to side, level at the crest and `over_m` above it.
  const auto past = [&](double over_m) {
    const Vec3 top_S_m = ground.site().p_S_m({crest.lon_rad, crest.lat_rad, crest_m + over_m});
    const Vec3 north_S = ground.site().north_S(top_S_m);
    return march.between(top_S_m - 3000 * north_S, top_S_m + 3000 * north_S);
  };
  EXPECT_FALSE(past(-1).is_free());
  EXPECT_NEAR(past(-1).clearance_m, -1, 0.05);
  EXPECT_TRUE(past(1).is_free());
  EXPECT_NEAR(past(1).clearance_m, 1, 0.05);
}

TEST(SightMarch, sees_itself_and_what_stands_beside_it) {
  const Ground ground = walled();
  SightMarch march(ground);
  const double height_m = ground.elevation_m(ground.site().origin()).value();
  const Vec3 here_S_m(0, 0, height_m + 2);
  EXPECT_TRUE(march.sees(here_S_m, here_S_m));
  EXPECT_NEAR(march.between(here_S_m, here_S_m).clearance_m, 2, 1e-6);
  EXPECT_TRUE(march.sees(here_S_m, here_S_m + Vec3(0.05, 0, 0)));
  EXPECT_TRUE(march.sees(here_S_m, here_S_m + Vec3(0, 0, 5)));
}

TEST(SightMarch, is_the_same_both_ways_and_hidden_by_the_body) {
  const Ground ground = walled();
  SightMarch march(ground);
  const Vec3 a_S_m = north_S_m(ground, 0, 100), b_S_m = north_S_m(ground, 9000, 700);
  EXPECT_NEAR(march.between(a_S_m, b_S_m).clearance_m, march.between(b_S_m, a_S_m).clearance_m,
              1e-6);
  EXPECT_FALSE(march.sees(a_S_m, north_S_m(ground, 5.4e6, 1000)));
}

}  // namespace
}  // namespace lsos
