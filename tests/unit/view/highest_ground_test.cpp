#include "view/ground/highest_ground.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

// On the Moon a chord is 12 km deep in its middle over 13.5 degrees: cos(6.74 deg) = 1 - 12/1737.4.
TEST(HighestGround, a_line_over_13_degrees_passes_under_all_ground) {
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(0, 0));
  const auto at = [&](double lon_deg) { return site.p_S_m(geodetic_from_degrees(lon_deg, 0)); };
  EXPECT_FALSE(passes_under_ground(site, at(0), at(13.4)));
  EXPECT_TRUE(passes_under_ground(site, at(0), at(13.6)));
  EXPECT_TRUE(passes_under_ground(site, at(100), at(-100)));
  EXPECT_FALSE(passes_under_ground(site, at(0), at(0)));
  // Beyond the body the nearer end of the line is its lowest point.
  EXPECT_FALSE(passes_under_ground(site, at(0), site.p_S_m(geodetic_from_degrees(0, 0, 1e8))));
}

// The north cap of Mars lies 20 km below its sphere, the plains around it 24 km.
TEST(HighestGround, polar_ground_of_mars_is_ground) {
  const Body& mars = *find_body("Mars");
  for (const double height_m : {-20e3, -24.3e3}) {
    const SiteFrame site(mars, geodetic_from_degrees(0, 80, height_m));
    EXPECT_FALSE(passes_under_ground(site, {0, 0, 2}, {500, 0, 2})) << height_m;
    EXPECT_GT(horizon_dip_rad(mars, height_m + 100), 0) << height_m;
  }
}

}  // namespace
}  // namespace lsos
