// The horizon that takes from the sky's light, against a march in far finer steps.
#include "view/exposure/terrain_horizon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "view/ground/horizon_march.h"

namespace lsos {
namespace {

// Share of an even sky's light on level ground that a horizon leaves: the mean of cos^2 h.
double open_share(const std::array<double, TerrainHorizon::azimuths>& elevation_rad) {
  double share = 0;
  for (const double h : elevation_rad)
    share += std::cos(h) * std::cos(h) / TerrainHorizon::azimuths;
  return share;
}

// In a crater of 80 m with smaller ones, rocks and roughness in it, 1 m above the ground.
TEST(TerrainHorizon, on_cratered_ground_leaves_the_light_that_a_finer_one_does) {
  const SiteFrame site{*find_body("Mars"), geodetic_from_degrees(0, 0)};
  TerrainSpec spec;
  ReliefSurface relief;
  relief.landforms = {{"bowl", 0, 0, 80, 14, 3}};
  spec.layers = {relief};
  Detail detail;
  detail.roughness = Roughness{0.02, 0.8, 10};
  detail.craters = CraterPopulation{};
  detail.craters->diameter_min_m = 1;
  detail.craters->age_gyr = 3;
  detail.rocks = RockPopulation{};
  detail.rocks->cover = 0.05;
  spec.detail = detail;
  const Ground ground(spec, site, 1);
  HorizonMarch march(ground, 0.4);
  for (const double x_m : {2., 16.}) {
    const auto eye = march.eye(site.geodetic({x_m, 0.5 * x_m, 0}), 1);
    ASSERT_TRUE(eye);
    std::array<double, TerrainHorizon::azimuths> fine{};
    for (std::size_t k = 0; k < fine.size(); ++k) {
      const double azimuth_rad = 2 * std::numbers::pi * static_cast<double>(k) / fine.size();
      const Vec3 along_S = std::cos(azimuth_rad) * site.north_S(eye->p_S_m) +
                           std::sin(azimuth_rad) * site.east_S(eye->p_S_m);
      fine[k] = std::max(0.0, march.towards(*eye, along_S, 0, 1.5, 0).elevation_rad);
    }
    const double found = open_share(terrain_horizon(ground, eye->p_S_m).elevation_rad);
    EXPECT_LT(open_share(fine), 0.95);
    EXPECT_NEAR(found, open_share(fine), 0.0015) << x_m;
  }
}

}  // namespace
}  // namespace lsos
