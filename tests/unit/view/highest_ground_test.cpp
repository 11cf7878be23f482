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

}  // namespace
}  // namespace lsos
