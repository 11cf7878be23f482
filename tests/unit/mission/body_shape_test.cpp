// The space that a rover takes up: at rest, with a limb stretched out, with a mast raised.
#include "mission/rover/body_shape.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mission/model/antenna.h"

namespace lsos::test {
namespace {

// A limb 3 m long on the chassis' front, folded back over it at rest.
VehicleConfig with_limb() {
  VehicleConfig vehicle;
  LinkConfig limb;
  limb.name = "limb";
  limb.axis = Vec3::UnitY();
  limb.p_PJ_m = {1, 0, 1};
  vehicle.links = {limb};
  return vehicle;
}

std::vector<Shape> shapes() {
  Shape chassis, limb;
  chassis.size_m = {2, 1, 1};
  chassis.p_B_m = {0, 0, 0.5};
  limb.size_m = {3, 0.1, 0.1};
  limb.p_B_m = {-0.5, 0, 1};
  limb.part = "limb";
  return {chassis, limb};
}

TEST(BodyShape, reaches_farther_with_a_limb_stretched_out) {
  const VehicleConfig vehicle = with_limb();
  const BodyShape shape(shapes(), vehicle);
  const PartPose chassis{{100, 200, 5}, Mat3::Identity()};
  EXPECT_NEAR(shape.reach_m(), std::hypot(2, 0.05, 1.05), 1e-6);
  EXPECT_NEAR(shape.reach_m(part_poses(vehicle, chassis, {0.0})), shape.reach_m(), 1e-6);
  const auto stretched = part_poses(vehicle, chassis, {std::numbers::pi});
  EXPECT_NEAR(shape.reach_m(stretched), std::hypot(4, 0.05, 1.05), 1e-6);
}

TEST(Antennas, reach_as_far_as_their_masts_do_when_up) {
  AntennaSpec fixed, mast;
  fixed.p_B_m = {0, 0, 50};
  mast.p_B_m = {0, 0, 30};
  mast.stowed_p_B_m = Vec3(0, 0, 2);
  EXPECT_EQ(AntennaArray({fixed}).mast_reach_m(), 0);
  const AntennaArray antennas({fixed, mast});
  const BodyShape raised(mast_shapes(mast, 28));
  EXPECT_GE(antennas.mast_reach_m(), raised.reach_m());
  EXPECT_LT(antennas.mast_reach_m(), 30.5);
}

}  // namespace
}  // namespace lsos::test
