// What SetPosture asks of ATHLETE: what is refused before anything moves, and what is reported when
// limbs could not do it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "mission/port/equipment_fault.h"
#include "mission/rover/rover_posture.h"
#include "physics/drive.h"
#include "vehicle/limb_hindrance.h"
#include "vehicle/limb_stance.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

std::unique_ptr<Ground> slope(double slope_rad) {
  return test::ground({.planet = "Moon",
                       .surface = PlaneSurface{0, slope_rad, radians(180)},
                       .soil = "ApolloNominal"});
}

// Why a change of stance is refused on a slope; "" when it is not.
std::string refusal(const VehicleConfig& config, const Ground& ground,
                    const PostureRequest& request) {
  Vehicle vehicle(config, ground);
  EXPECT_EQ(vehicle.put_down(ground.site().origin(), 0), "");
  try {
    set_posture(vehicle, request);
  } catch (const EquipmentFault& fault) {
    return fault.what();
  }
  return "";
}

TEST(PostureRequest, is_refused_where_limbs_that_level_the_chassis_would_reach_their_ends) {
  const auto level = slope(0), hill = slope(radians(15));
  const VehicleConfig config = test::rover_on("ATHLETE", *level, "Moon");
  const double height_m = height_range(config).greatest_m - 0.1;
  EXPECT_EQ(refusal(config, *level, {.height_m = height_m}), "");
  EXPECT_THAT(refusal(config, *hill, {.height_m = height_m}), HasSubstr("limb_"));
  EXPECT_EQ(refusal(config, *hill, {.height_m = 1.2}), "");
}

TEST(PostureRequest, of_a_rover_without_posture_control_has_no_level) {
  const auto hill = slope(radians(10));
  VehicleConfig config = test::rover_on("ATHLETE", *hill, "Moon");
  config.posture.reset();
  EXPECT_EQ(refusal(config, *hill, {.is_level = true}),
            "Level: ATHLETE has no posture control: it lies as the ground does");
  EXPECT_EQ(refusal(config, *hill, {.height_m = 1.0}), "");
  // Lying on the slope, its centre of mass is not over its wheels any more.
  config.p_BC_m.z() = 40;
  EXPECT_EQ(refusal(config, *hill, {.height_m = 1.0}),
            "its centre of mass would not be over its wheels");
}

// It stands level, but will lie as the slope does.
TEST(PostureRequest, to_lie_as_the_ground_does_is_checked_for_balance_there) {
  const auto hill = slope(radians(10));
  VehicleConfig config = test::rover_on("ATHLETE", *hill, "Moon");
  EXPECT_EQ(refusal(config, *hill, {.is_level = false}), "");
  config.p_BC_m.z() = 40;
  EXPECT_EQ(refusal(config, *hill, {.is_level = true}), "");
  EXPECT_EQ(refusal(config, *hill, {.is_level = false}),
            "its centre of mass would not be over its wheels");
}

TEST(PostureRequest, for_level_alone_ends_where_a_move_under_way_would_have_ended) {
  const auto level = slope(0);
  Vehicle vehicle(test::rover_on("ATHLETE", *level, "Moon"), *level);
  ASSERT_EQ(vehicle.place(level->site().origin(), 0), "");
  set_posture(vehicle, {.height_m = 1.5});
  for (int i = 0; i < 20; ++i) vehicle.advance(exchange_period);
  ASSERT_LT(posture_clearance_m(vehicle), 1.4);
  set_posture(vehicle, {.is_level = true});
  for (int i = 0; i < 600 && vehicle.is_adjusting(); ++i) vehicle.advance(exchange_period);
  EXPECT_NEAR(posture_clearance_m(vehicle), 1.5, 0.03);
  EXPECT_EQ(stance_fault(vehicle), "");
}

// On the Moon it weighs 1380 N: its hips hold some 200 N m each.
TEST(PostureRequest, beyond_the_strength_of_its_motors_is_reported_with_the_real_height) {
  const auto level = slope(0);
  VehicleConfig config = test::rover_on("ATHLETE", *level, "Moon");
  for (LinkConfig& link : config.links) {
    if (link.limb) link.limb->motor.torque_max_n_m = 60;
  }
  Vehicle vehicle(config, *level);
  ASSERT_EQ(vehicle.place(level->site().origin(), 0), "");
  set_posture(vehicle, {.height_m = 1.9});
  for (int i = 0; i < 1200 && vehicle.is_adjusting(); ++i) vehicle.advance(exchange_period);
  ASSERT_FALSE(vehicle.is_adjusting());
  const double chassis_m = vehicle.part_poses().front().p_S_m.z() + config.chassis_clearance_m;
  EXPECT_LT(chassis_m, 1.5);
  EXPECT_NEAR(posture_clearance_m(vehicle), chassis_m, 0.05);
  EXPECT_THAT(stance_fault(vehicle),
              MatchesRegex("its chassis is [0-9.]+ m over the ground instead of 1.90 m: the motor "
                           "of limb_[1-6]_[a-z_]+ gives no more than 60 N m"));
}

TEST(PostureRequest, that_a_limb_breaks_off_is_reported_with_its_joint) {
  const auto level = slope(0);
  const VehicleConfig config = test::rover_on("ATHLETE", *level, "Moon");
  Vehicle vehicle(config, *level);
  ASSERT_EQ(vehicle.place(level->site().origin(), 0), "");
  EXPECT_EQ(stance_fault(vehicle), "");
  set_posture(vehicle, {.height_m = 1.9});
  for (int i = 0; i < 20; ++i) vehicle.advance(exchange_period);
  for (const int joint : config.limbs[2].joints) vehicle.set_limb_locked(joint, true);
  for (int i = 0; i < 1200 && vehicle.is_adjusting(); ++i) vehicle.advance(exchange_period);
  EXPECT_THAT(stance_fault(vehicle), HasSubstr("limb_3_hip_yaw is locked"));
}

}  // namespace
}  // namespace lsos
