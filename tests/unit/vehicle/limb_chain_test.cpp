#include "vehicle/limb_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/vehicle/test_limbs.h"
#include "vehicle/limb_stance.h"
#include "vehicle/posture_move.h"

namespace lsos {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

VehicleConfig vehicle() { return make_vehicle(test::rover_on_limbs(), "", 1.6); }

// The first limb reaches out at 30 degrees: its plane by distance from the middle and height.
Vec3 in_plane(double r_m, double z_m) {
  const double azimuth_rad = std::numbers::pi / 6;
  return {r_m * std::cos(azimuth_rad), r_m * std::sin(azimuth_rad), z_m};
}

TEST(LimbChain, pose_is_that_of_two_links_in_a_plane) {
  const VehicleConfig v = vehicle();
  const LimbChain chain(v, v.limbs.front());
  EXPECT_NEAR((chain.at_rest().hub_B_m - in_plane(test::wheel_r_m, 0.5)).norm(), 0, 1e-12);
  // A turn of the hip turns thigh and shin together about it.
  const double turn = 0.3;
  const double dr = test::wheel_r_m - test::hip_r_m, dz = 0.5 - test::hip_z_m;
  const Vec3 turned = in_plane(test::hip_r_m + dr * std::cos(turn) + dz * std::sin(turn),
                               test::hip_z_m + dz * std::cos(turn) - dr * std::sin(turn));
  const LimbPose pose = chain.pose({0, turn, 0});
  EXPECT_NEAR((pose.hub_B_m - turned).norm(), 0, 1e-12);
  EXPECT_NEAR(pose.up_B.z(), std::cos(turn), 1e-12);
}

// The distance from hip to hub gives the angle at the knee by the law of cosines.
TEST(LimbChain, reach_agrees_with_the_law_of_cosines) {
  const VehicleConfig v = vehicle();
  const LimbChain chain(v, v.limbs.front());
  const auto knee_rad = [](double reach_m) {
    return std::acos(
        (test::thigh_m * test::thigh_m + test::shin_m * test::shin_m - reach_m * reach_m) /
        (2 * test::thigh_m * test::shin_m));
  };
  const double at_rest_m = std::hypot(test::wheel_r_m - test::hip_r_m, 0.5 - test::hip_z_m);
  for (const double z_m : {0.9, 0.2, -0.3}) {
    const LimbChain::Reach reach = chain.reach(in_plane(test::wheel_r_m, z_m), {0, 0, 0});
    EXPECT_LT(reach.error_m, hub_reached_m / 5) << z_m;
    const double now_m = std::hypot(test::wheel_r_m - test::hip_r_m, z_m - test::hip_z_m);
    EXPECT_NEAR(std::abs(reach.angles_rad[2]), std::abs(knee_rad(now_m) - knee_rad(at_rest_m)),
                5e-4)
        << z_m;
    EXPECT_NEAR(reach.angles_rad[0], 0, 1e-6);
  }
}

TEST(LimbChain, a_limb_that_is_too_short_or_at_its_stop_says_so) {
  VehicleConfig v = vehicle();
  const std::vector<Vec3> deep{in_plane(test::wheel_r_m, -2)};
  {
    VehicleConfig wide = v;
    for (LinkConfig& link : wide.links) {
      if (link.limb) link.limb->angle_min_rad = -(link.limb->angle_max_rad = 3);
    }
    const LimbChain chain(wide, wide.limbs.front());
    const LimbChain::Reach reach = chain.reach(deep.front(), {0, 0, 0});
    // Stretched, the limb ends its length from the hip.
    const double far_m = std::hypot(test::wheel_r_m - test::hip_r_m, 3.0);
    EXPECT_NEAR(reach.error_m, far_m - test::thigh_m - test::shin_m, 0.02);
    EXPECT_THAT(reach_text(wide, wide.limbs.front(), reach), HasSubstr("it is too short"));
  }
  for (LinkConfig& link : v.links) {
    if (link.name == "limb_1_knee") link.limb->angle_min_rad = link.limb->angle_max_rad = 0;
  }
  const LimbChain chain(v, v.limbs.front());
  const LimbChain::Reach reach = chain.reach(in_plane(test::wheel_r_m, 0), {0, 0, 0});
  EXPECT_GT(reach.error_m, 0.1);
  EXPECT_THAT(reach_text(v, v.limbs.front(), reach),
              HasSubstr("limb_1_knee is at the end of its range"));
}

TEST(LimbChain, a_locked_joint_does_not_turn) {
  const VehicleConfig v = vehicle();
  const LimbChain chain(v, v.limbs.front());
  const LimbChain::Reach reach =
      chain.reach(in_plane(test::wheel_r_m, 0.3), {0, 0, 0}, {false, false, true});
  EXPECT_EQ(reach.angles_rad[2], 0);
  EXPECT_GT(reach.error_m, 0.01);
}

TEST(Stance, height_moves_all_hubs_alike_and_back) {
  VehicleConfig v = vehicle();
  const std::vector<Vec3> at_rest = hubs_B_m(v);
  EXPECT_NEAR(height_m(v, at_rest), 0.8, 1e-12);
  const std::vector<Vec3> high = at_height(v, at_rest, 1.1);
  EXPECT_NEAR(height_m(v, high), 1.1, 1e-12);
  EXPECT_EQ(stand(v, high), "");
  const std::vector<Vec3> reached = hubs_B_m(v);
  for (std::size_t i = 0; i < high.size(); ++i) {
    EXPECT_NEAR((reached[i] - high[i]).norm(), 0, 1e-3) << i;
  }
  const VehicleConfig standing = as_it_stands(v);
  EXPECT_NEAR(standing.chassis_clearance_m, 1.1, 1e-3);
  EXPECT_NEAR(standing.p_BC_m.z(), 1.3, 1e-3);
  EXPECT_NEAR(standing.mass_kg(), v.mass_kg(), 1e-9);
  for (const Vec3& hub : hubs_B_m(standing)) EXPECT_NEAR(hub.z(), 0.5, 1e-3);
}

// With a fourth and fifth joint at the hub a limb can hold its wheel upright, as far as these turn.
TEST(Stance, heights_end_where_a_wheel_would_lean) {
  RoverSpec spec = test::rover_on_limbs();
  const auto with_ankles = [&](double range_rad) {
    RoverSpec changed = spec;
    for (Limb& limb : std::get<Legged>(changed.suspension).limbs) {
      for (LimbJoint& joint : limb.joints) {
        joint.actuator.angle_min_rad = -(joint.actuator.angle_max_rad = 2.5);
      }
      LimbJoint ankle = limb.joints.back();
      ankle.name = "ankle";
      ankle.p_B_m = Vec3(limb.p_B_wheel_m.x(), limb.p_B_wheel_m.y(), 0.6);
      ankle.actuator.angle_min_rad = -(ankle.actuator.angle_max_rad = range_rad);
      LimbJoint roll = ankle;
      roll.name = "roll";
      roll.axis_B = ankle.axis_B.cross(Vec3::UnitZ());
      limb.joints.push_back(ankle);
      limb.joints.push_back(roll);
    }
    return make_vehicle(changed, "", 1.6);
  };
  const VehicleConfig stiff = with_ankles(0.2), free = with_ankles(1.5);
  const HeightRange narrow = height_range(stiff), wide = height_range(free);
  EXPECT_LT(narrow.greatest_m, wide.greatest_m - 0.05);
  VehicleConfig high = stiff;
  EXPECT_THAT(stand(high, at_height(high, hubs_B_m(high), narrow.greatest_m + 0.02)),
              HasSubstr("limb_1_ankle is at the end of its range"));
  EXPECT_EQ(stand(high, at_height(high, hubs_B_m(stiff), narrow.greatest_m - 0.01)), "");
  const LimbChain chain(high, high.limbs.front());
  std::vector<double> angles_rad;
  for (const int joint : high.limbs.front().joints) {
    angles_rad.push_back(high.links[static_cast<std::size_t>(joint)].initial);
  }
  EXPECT_GT(chain.pose(angles_rad).up_B.z(), std::cos(upright_within_rad));
}

TEST(PostureMove, takes_as_long_as_its_slowest_joint) {
  const VehicleConfig v = vehicle();
  const std::vector<Vec3> from = hubs_B_m(v), to = at_height(v, from, 1.0);
  const std::vector<std::vector<double>> angles(6, std::vector<double>(3, 0.0));
  const std::vector<std::vector<bool>> free(6, std::vector<bool>(3, false));
  const PostureMove move = posture_move(v, from, to, angles, free);
  EXPECT_EQ(move.hindrance, "");
  // No joint turns less than on the whole way; the fastest part sets the pace.
  const LimbChain chain(v, v.limbs.front());
  const LimbChain::Reach end = chain.reach(to[0], {0, 0, 0});
  const double whole_s = std::max(std::abs(end.angles_rad[1]), std::abs(end.angles_rad[2])) / 0.2;
  EXPECT_GE(move.least_s, whole_s);
  EXPECT_LT(move.least_s, 1.5 * whole_s);
  EXPECT_THAT(move.slowest_joint, HasSubstr("limb_1_"));
}

TEST(PostureMove, names_what_hinders_it) {
  const VehicleConfig v = vehicle();
  const std::vector<Vec3> from = hubs_B_m(v);
  const std::vector<std::vector<double>> angles(6, std::vector<double>(3, 0.0));
  std::vector<std::vector<bool>> locked(6, std::vector<bool>(3, false));
  locked[3][2] = true;
  EXPECT_THAT(posture_move(v, from, at_height(v, from, 1.2), angles, locked).hindrance,
              ::testing::MatchesRegex("limb_4 ends 0.[0-9]+ m from .*; limb_4_knee is locked"));
  std::vector<Vec3> wide = from;
  wide[1].y() += 0.3;
  locked[3][2] = false;
  EXPECT_THAT(posture_move(v, from, wide, angles, locked).hindrance,
              HasSubstr("the wheel of limb_2 stands 0.30 m from where it would be"));
}

}  // namespace
}  // namespace lsos
