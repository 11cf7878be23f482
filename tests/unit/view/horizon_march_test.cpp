#include "view/ground/horizon_march.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "terrain/detail/landforms.h"
#include "unit/view/view_fixture.h"

namespace lsos {
namespace {

using test::deg;
const SiteFrame site{*find_body("Moon"), geodetic_from_degrees(0, -85)};

HorizonPoint look(const Ground& ground, double height_m, double azimuth_rad, double lowest_rad) {
  HorizonMarch march(ground, 0.5);
  const auto eye = march.eye(site.origin(), height_m);
  const Vec3 along_S = std::cos(azimuth_rad) * site.north_S(eye->p_S_m) +
                       std::sin(azimuth_rad) * site.east_S(eye->p_S_m);
  return march.towards(*eye, along_S, lowest_rad, 80 * deg, 0);
}

Ground ground_with(std::vector<Landform> landforms) {
  TerrainSpec spec;
  ReliefSurface relief;
  relief.lat_rad = -85 * deg;
  relief.landforms = std::move(landforms);
  spec.layers = {relief};
  return Ground(spec, site, 1);
}

// The horizon of a sphere from a height h dips by acos(R/(R + h)), and is sqrt(2 R h + h^2) away.
TEST(HorizonMarch, of_level_ground_dips_as_that_of_a_sphere) {
  const Ground ground = ground_with({});
  const double radius_m = site.body().equatorial_radius_m;
  for (const double height_m : {2.0, 30.0, 500.0}) {
    const double dip_rad = std::acos(radius_m / (radius_m + height_m));
    const HorizonPoint found = look(ground, height_m, 1, -5 * deg);
    EXPECT_NEAR(found.elevation_rad, -dip_rad, 0.001 * dip_rad) << height_m;
    EXPECT_NEAR(found.distance_m, std::sqrt(2 * radius_m * height_m), 0.03 * found.distance_m);
    EXPECT_TRUE(found.is_known);
  }
}

// From the middle of a crater its wall stands around, whose profile is searched in steps of 0.1 m.
TEST(HorizonMarch, in_a_crater_is_its_wall) {
  const Landform bowl{"bowl", 0, -85 * deg, 700, 90, 20};
  const Ground ground = ground_with({bowl});
  double highest_rad = 0, at_m = 0;
  for (double x_m = 1; x_m < 400; x_m += 0.1) {
    const double up_m = landform_height_m(bowl, x_m / 350) - landform_height_m(bowl, 0) -
                        x_m * x_m / 2 / site.body().equatorial_radius_m;
    if (std::atan2(up_m, x_m) <= highest_rad) continue;
    highest_rad = std::atan2(up_m, x_m);
    at_m = x_m;
  }
  EXPECT_GT(highest_rad, 14 * deg);
  for (int k = 0; k < 12; ++k) {
    const HorizonPoint found = look(ground, 0, k * 30 * deg, 0);
    // The relief is sampled every 16 m.
    EXPECT_NEAR(found.elevation_rad, highest_rad, 0.1 * deg) << k;
    EXPECT_NEAR(found.distance_m, at_m, 10) << k;
  }
}

}  // namespace
}  // namespace lsos
