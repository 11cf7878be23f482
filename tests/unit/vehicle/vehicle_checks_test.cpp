// Faults that the templates' own checks cannot produce, on vehicles modified link by link.
#include "vehicle/suspension/vehicle_checks.h"

#include <gmock/gmock.h>

#include "test_rovers.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

VehicleConfig four_wheels() {
  VehicleConfig vehicle = test::small_body();
  add_skid_steer(vehicle, test::skid_steer());
  return vehicle;
}

TEST(RestFaults, tell_of_wheels_that_are_not_on_the_ground) {
  VehicleConfig vehicle = four_wheels();
  EXPECT_THAT(rest_faults(vehicle), IsEmpty());
  vehicle.links[0].p_PJ_m.z() = 0.1;
  vehicle.links[3].p_PJ_m.z() = 0.2;
  EXPECT_THAT(rest_faults(vehicle),
              ElementsAre("front_left_wheel: its hub is 0.100 m above the ground at rest and its "
                          "radius is 0.15 m: it is 0.050 m below the ground",
                          "rear_right_wheel: its hub is 0.200 m above the ground at rest and its "
                          "radius is 0.15 m: it is 0.050 m off the ground"));
}

TEST(RestFaults, tell_of_too_few_wheels) {
  VehicleConfig vehicle = four_wheels();
  vehicle.links.resize(2);
  EXPECT_THAT(rest_faults(vehicle), ElementsAre("2 wheels: at least 3 are needed to stand on"));
}

TEST(RestFaults, wheels_in_one_line_do_not_hold_a_rover_up) {
  VehicleConfig vehicle = four_wheels();
  for (LinkConfig& link : vehicle.links) link.p_PJ_m.y() = 0;
  EXPECT_EQ(balance_faults(vehicle).size(), 1u);
}

TEST(BalanceFaults, count_the_whole_vehicle) {
  // Axles at 0.4 and -0.4; 120 kg of body and 8 kg of wheels: the body's centre of mass may be up
  // to 128/120 x 0.4 m from the middle.
  VehicleConfig vehicle = four_wheels();
  vehicle.p_BC_m.x() = 0.42;
  EXPECT_THAT(balance_faults(vehicle), IsEmpty());
  vehicle.p_BC_m.x() = 0.43;
  EXPECT_EQ(balance_faults(vehicle).size(), 1u);
}

}  // namespace
}  // namespace lsos
