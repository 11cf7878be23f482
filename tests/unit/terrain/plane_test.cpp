#include <cmath>

#include "ground_fixture.h"

namespace lsos {
namespace {

TEST(Plane, level_ground_follows_the_body) {
  const SiteFrame site = site_on("Moon", 10, 20, 1500);
  const Ground ground(plane_terrain(1500), site, 0);
  Ground::Probe probe(ground);
  EXPECT_NEAR(probe.sample(Vec3::Zero()).gap_m, 0, 1e-9);
  EXPECT_LT((probe.sample(Vec3::Zero()).normal_S - Vec3::UnitZ()).norm(), 1e-15);
  // 10 km away the ground is 28.8 m below the tangent plane and 0.33 degrees tilted.
  const GroundSample far = probe.sample({0, 10000, 0});
  EXPECT_EQ(far.elevation_m, 1500);
  EXPECT_NEAR(far.gap_m, 10000.0 * 10000 / (2 * 1738900), 1e-3);
  EXPECT_LT((far.normal_S - site.up_S({0, 10000, 0})).norm(), 1e-12);
  EXPECT_NEAR(far.normal_S.y(), 10000 / 1738900.0, 1e-7);
  EXPECT_EQ(ground.elevation_m(geodetic_from_degrees(10.2, 20.1)), 1500);
}

TEST(Plane, slopes_down_towards_its_azimuth) {
  const double slope_rad = 0.3;
  // The ground falls towards the east.
  const Ground ground(plane_terrain(200, slope_rad, M_PI / 2), site_on("Mars", 0, 50, 200), 0);
  Ground::Probe probe(ground);
  const GroundSample here = probe.sample({0, 0, 2});
  EXPECT_NEAR(here.gap_m, 2, 1e-9);
  EXPECT_LT((here.normal_S - Vec3(std::sin(slope_rad), 0, std::cos(slope_rad))).norm(), 1e-9);
  EXPECT_NEAR(probe.sample({10, 0, 0}).elevation_m, 200 - 10 * std::tan(slope_rad), 1e-4);
  EXPECT_NEAR(probe.sample({0, 10, 0}).elevation_m, 200, 1e-9);
}

TEST(Plane, has_its_slope_also_far_above_the_reference_surface) {
  // The site lies at the reference surface, the ground 20 km above it.
  const Ground ground(plane_terrain(20000, 0.2, 0), site_on("Moon", 0, 50, 0), 0);
  Ground::Probe probe(ground);
  const GroundSample here = probe.sample({0, 0, 20000});
  EXPECT_NEAR(std::acos(here.normal_S.z()), 0.2, 1e-9);
}

TEST(Plane, is_linear_in_the_tangent_plane) {
  const SiteFrame site = site_on("Moon", 0, 0);
  const Ground ground(plane_terrain(0, 0.1, 1.0), site, 0);
  Ground::Probe probe(ground);
  for (double x : {-731.3, -16.0, 0.7, 512.0}) {
    for (double y : {-200.1, 33.3}) {
      // The point lies straight above the tangent plane's, on the line to the body's centre.
      const double expected = -std::tan(0.1) * (x * std::sin(1.0) + y * std::cos(1.0));
      EXPECT_NEAR(probe.sample({x, y, 0}).elevation_m, expected, 1e-11);
    }
  }
}

TEST(Plane, has_no_ground_on_the_far_side) {
  const Ground ground(plane_terrain(0), site_on("Moon", 0, 0), 0);
  Ground::Probe probe(ground);
  EXPECT_FALSE(probe.sample({0, 0, -3.4e6}).is_ground());
  EXPECT_FALSE(ground.elevation_m(geodetic_from_degrees(120, 0)));
  EXPECT_TRUE(ground.elevation_m(geodetic_from_degrees(50, 0)));
}

TEST(Plane, normals_are_gradients_of_the_gap_on_every_body) {
  for (const Body& body : all_bodies()) {
    const Ground ground(plane_terrain(3000, 0.25, 4), site_on(body.name, 20, 40, 3000), 0);
    Ground::Probe probe(ground);
    const Vec3 p = on_surface(ground, probe, {4000, -7000, 0});
    EXPECT_NEAR(probe.sample(p).gap_m, 0, 1e-7);
    EXPECT_LT((probe.sample(p).normal_S - normal_by_differences(probe, p, 1)).norm(), 1e-8)
        << body.name;
    const Vec3 above = p + 100 * ground.site().up_S(p);
    EXPECT_LT((probe.sample(above).normal_S - probe.sample(p).normal_S).norm(), 1e-7);
  }
}

TEST(Plane, hash_follows_its_values) {
  const SiteFrame site = site_on("Moon", 0, 0);
  const std::string first = Ground(plane_terrain(0, 0.1, 1), site, 0).hash();
  EXPECT_EQ(Ground(plane_terrain(0, 0.1, 1), site, 5).hash(), first);
  EXPECT_NE(Ground(plane_terrain(0, 0.1, 1.0000001), site, 0).hash(), first);
}

TEST(Plane, carries_its_soil) {
  TerrainSpec spec = plane_terrain(0);
  spec.soil.name = "LunarHighland";
  EXPECT_EQ(Ground(spec, site_on("Moon", 0, 0), 0).soils().front().name, "LunarHighland");
}

}  // namespace
}  // namespace lsos
