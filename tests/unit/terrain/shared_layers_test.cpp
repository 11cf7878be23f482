// Layers that grounds of one process share.
#include <gtest/gtest.h>

#include "planet/ellipsoid.h"
#include "terrain/ground.h"

namespace lsos {
namespace {

TerrainSpec rough_plane(double deviation_m) {
  TerrainSpec terrain;
  terrain.name = "Rough";
  terrain.layers = {PlaneSurface{}};
  terrain.detail.emplace();
  terrain.detail->roughness = Roughness{deviation_m};
  return terrain;
}

const SiteFrame& moon_at(double lon_deg) {
  static const SiteFrame here(*find_body("Moon"), geodetic_from_degrees(10, 20));
  static const SiteFrame there(*find_body("Moon"), geodetic_from_degrees(11, 20));
  return lon_deg == 10 ? here : there;
}

const Geodetic place = geodetic_from_degrees(10.001, 20);

TEST(SharedLayers, are_those_of_equal_ground_whatever_its_soil) {
  const double alone_m = *Ground(rough_plane(0.02), moon_at(10), 7).elevation_m(place);
  {
    const Ground first(rough_plane(0.02), moon_at(10), 7);
    EXPECT_FALSE(first.has_shared_layers());
    ASSERT_TRUE(first.share_layers());
  }
  TerrainSpec softer = rough_plane(0.02);
  softer.soil.cohesion_pa = 123;
  const Ground second(softer, moon_at(10), 7);
  EXPECT_TRUE(second.has_shared_layers());
  EXPECT_EQ(second.elevation_m(place), alone_m);
  EXPECT_EQ(second.soils().front().cohesion_pa, 123);
  // What it has taken outlives the ground that is shared after it.
  ASSERT_TRUE(Ground(rough_plane(0.02), moon_at(10), 17).share_layers());
  EXPECT_EQ(second.elevation_m(place), alone_m);
}

TEST(SharedLayers, are_none_of_other_ground) {
  ASSERT_TRUE(Ground(rough_plane(0.02), moon_at(10), 9).share_layers());
  EXPECT_FALSE(Ground(rough_plane(0.02), moon_at(10), 8).has_shared_layers()) << "another seed";
  EXPECT_FALSE(Ground(rough_plane(0.03), moon_at(10), 9).has_shared_layers()) << "other roughness";
  EXPECT_FALSE(Ground(rough_plane(0.02), moon_at(11), 9).has_shared_layers()) << "another site";
  EXPECT_TRUE(Ground(rough_plane(0.02), moon_at(10), 9).has_shared_layers());
}

}  // namespace
}  // namespace lsos
