// Explanations of places where a rover cannot stand or drive.
#include "route/cost/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/route/test_rover.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// The explanation for a rover with this stance.
std::string told(const Stance& stance, Hazard expected) {
  const DriveCost cost = simple_rover();
  const Hazard found = hazard(stance, cost);
  EXPECT_EQ(found, expected);
  return describe(found, stance, cost);
}

Stance on_slope(double pitch_rad, double bank_rad) {
  Stance stance;
  stance.is_on_ground = true;
  stance.clearance_m = 0.4;
  stance.pitch_rad = pitch_rad;
  stance.bank_rad = bank_rad;
  stance.slope_rad = std::hypot(pitch_rad, bank_rad);
  return stance;
}

TEST(Explain, says_what_is_found_and_what_is_allowed) {
  EXPECT_EQ(told(on_slope(25 * deg, 0), Hazard::slope), "on a slope of 25 degrees, 20 are allowed");
  Stance uneven = on_slope(0, 0);
  uneven.unevenness_m = 0.302;
  EXPECT_EQ(told(uneven, Hazard::uneven), "uneven by 0.302 m at a wheel, 0.300 are allowed");
  Stance low = on_slope(0, 0);
  low.clearance_m = 0.05;
  EXPECT_EQ(told(low, Hazard::clearance), "with 0.05 m under the chassis, 0.10 are wanted");
  EXPECT_EQ(told({}, Hazard::no_ground), "where the terrain is not known");
}

TEST(Explain, says_which_way_a_rover_slides) {
  DriveCost cost = simple_rover();
  cost.limits.slope_max_rad = 40 * deg;
  for (SlopeDrive& drive : cost.soils[0].by_slope) drive.slip *= 2;
  const Stance across = on_slope(0, 24 * deg);
  ASSERT_EQ(hazard(across, cost), Hazard::slide);
  EXPECT_EQ(describe(Hazard::slide, across, cost), "across a slope of 24 degrees, where it slides");
  const Stance down = on_slope(-28 * deg, 0);
  EXPECT_EQ(describe(Hazard::slide, down, cost),
            "down a slope of 28 degrees, where brakes do not hold it");
  const Stance up = on_slope(24.5 * deg, 0);
  ASSERT_EQ(hazard(up, cost), Hazard::climb);
  EXPECT_EQ(describe(Hazard::climb, up, cost),
            "up a slope of 24.5 degrees, its wheels climb 23.8 on this soil");
}

}  // namespace
}  // namespace lsos::test
