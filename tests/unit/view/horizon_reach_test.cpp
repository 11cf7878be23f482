// How far away ground can matter, against known relief and against a search.
#include "view/ground/horizon_reach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "view/ground/highest_ground.h"

namespace lsos {
namespace {

// Rises of the steepest great slopes known, with the distance within which they rise.
TEST(HorizonReach, no_known_relief_is_greater) {
  struct Relief {
    const char* name;
    double rise_m, within_m;
  };
  for (const Relief& relief : {Relief{"Shackleton's wall (LOLA)", 4200, 7200},
                               {"Rakaposhi from the Hunza valley", 5900, 11500},
                               {"Nanga Parbat from the Indus", 7000, 27000},
                               {"Coprates Chasma's wall", 8500, 20000},
                               {"Olympus Mons over the plains", 22000, 300e3},
                               {"Mons Huygens", 5500, 14000}}) {
    EXPECT_LT(relief.rise_m, greatest_rise_m(relief.within_m)) << relief.name;
  }
}

// The greatest distance at which such ground stands above the ray, by a search in small steps.
double searched_m(const Body& body, double eye_m, double elevation_rad) {
  double farthest_m = 0;
  for (double d_m = 1; d_m < 700e3; d_m *= 1.0005) {
    const double ray_m = d_m * std::tan(elevation_rad) + d_m * d_m / (2 * body.equatorial_radius_m);
    if (std::min(greatest_rise_m(d_m), body.highest_ground_m - eye_m) > ray_m) farthest_m = d_m;
  }
  return farthest_m;
}

TEST(HorizonReach, is_where_the_greatest_ground_meets_the_ray) {
  for (const char* name : {"Moon", "Mars", "Earth"}) {
    const Body& body = *find_body(name);
    for (const double eye_m : {-4500.0, 0.0, 2000.0}) {
      for (const double deg : {-1.0, 0.0, 0.5, 2.0, 5.0, 12.0, 25.0, 38.0}) {
        const double expected_m = searched_m(body, eye_m, radians(deg));
        EXPECT_NEAR(horizon_reach_m(body, eye_m, radians(deg)), expected_m, 1e-3 * expected_m + 1)
            << name << " " << eye_m << " " << deg;
      }
    }
  }
}

TEST(HorizonReach, is_none_for_a_high_sun) {
  const Body& moon = *find_body("Moon");
  EXPECT_EQ(horizon_reach_m(moon, 0, radians(41)), 0);
  EXPECT_EQ(horizon_reach_m(moon, 0, radians(90)), 0);
  // Level rays: 10.8 km of ground sink below the horizon at sqrt(2 R H).
  EXPECT_NEAR(horizon_reach_m(moon, 0, 0), std::sqrt(2 * 1737400.0 * 10800), 1);
  // From high above all ground nothing hides a level ray.
  EXPECT_EQ(horizon_reach_m(moon, 20e3, 0), 0);
}

}  // namespace
}  // namespace lsos
