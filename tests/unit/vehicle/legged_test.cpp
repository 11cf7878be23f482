#include "vehicle/suspension/legged.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/vehicle/test_limbs.h"
#include "unit/vehicle/wheel_loads.h"
#include "vehicle/limb_stance.h"
#include "vehicle/suspension/vehicle_checks.h"
#include "vehicle/vehicle.h"

namespace lsos {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

VehicleConfig vehicle(const RoverSpec& spec = test::rover_on_limbs(),
                      const std::string& configuration = "") {
  return make_vehicle(spec, configuration, 1.6);
}

double tilt_rad(Vehicle& vehicle) {
  const VehicleReport report = vehicle.report();
  return std::acos(std::cos(report.pitch_rad) * std::cos(report.roll_rad));
}

std::vector<double> loads_n(const Vehicle& vehicle) {
  std::vector<double> loads;
  for (std::size_t i = 0; i < 6; ++i) loads.push_back(vehicle.wheel_load_n(i));
  return loads;
}

TEST(Legged, builds_a_chain_for_each_limb) {
  const VehicleConfig v = vehicle();
  EXPECT_THAT(vehicle_faults(test::rover_on_limbs()), IsEmpty());
  ASSERT_EQ(v.links.size(), 6u * 5);
  EXPECT_EQ(v.links[0].name, "limb_1_yaw");
  EXPECT_EQ(v.links[3].name, "limb_1_steering");
  EXPECT_EQ(v.links[4].name, "limb_1_wheel");
  EXPECT_NEAR(v.mass_kg(), 400 + 6 * (10 + 20 + 15 + 10 + 20), 1e-9);
  ASSERT_EQ(v.limbs.size(), 6u);
  EXPECT_THAT(v.limbs[1].joints, ElementsAre(5, 6, 7));
  EXPECT_EQ(v.limbs[1].wheel, 9);
}

TEST(Legged, what_cannot_work_is_said) {
  const auto faults_of = [](const auto& change) {
    RoverSpec spec = test::rover_on_limbs();
    change(spec, std::get<Legged>(spec.suspension));
    return vehicle_faults(spec);
  };
  EXPECT_THAT(faults_of([](RoverSpec&, Legged& s) { s.limbs[1].name = "limb_1"; }),
              Contains("two limbs are named 'limb_1'"));
  EXPECT_THAT(faults_of([](RoverSpec&, Legged& s) { s.limbs[0].joints[1].name = "yaw"; }),
              ElementsAre("limb 'limb_1' has two joints named 'yaw'"));
  EXPECT_THAT(faults_of([](RoverSpec&, Legged& s) { s.limbs[0].joints[1].name = "wheel"; }),
              ElementsAre(HasSubstr("no joint may be named 'wheel'")));
  EXPECT_THAT(faults_of([](RoverSpec&, Legged& s) { s.limbs[2].joints.clear(); }),
              ElementsAre("limb 'limb_3' has no joints: it needs at least one"));
  EXPECT_THAT(faults_of([](RoverSpec&, Legged& s) {
                s.limbs[0].joints[2].actuator.motor.stiffness_n_m_prad = 1e7;
              }),
              Contains(HasSubstr("too long for the limb's servo of limb_1_knee")));
  EXPECT_THAT(faults_of([](RoverSpec& spec, Legged&) { spec.vehicle.p_BC_m.x() = 4; }),
              Contains(HasSubstr("it would tip over at rest")));
  EXPECT_THAT(faults_of([](RoverSpec& spec, Legged&) {
                spec.configurations = {{.name = "High", .height_m = 3}};
              }),
              ElementsAre(::testing::MatchesRegex(
                  "configuration 'High': height_m = 3: limb_1 ends [0-9.]+ m from where its wheel "
                  "would stand.*")));
  EXPECT_THAT(faults_of([](RoverSpec& spec, Legged&) {
                spec.configurations = {{.name = "Bent", .joints = {{"limb_1_hip", 0.5}}}};
              }),
              Contains(HasSubstr("configuration 'Bent': limb_1_wheel: its hub is")));
}

TEST(Legged, height_is_for_limbs_only) {
  RoverSpec spec;
  spec.name = "Test";
  spec.vehicle = test::rover(1.6);
  spec.vehicle.links.clear();
  spec.suspension = test::suspension();
  spec.configurations = {{.name = "High", .height_m = 1}};
  EXPECT_THAT(vehicle_faults(spec),
              Contains(HasSubstr("height_m = 1: only a rover on limbs (lsos.legged)")));
}

TEST(Legged, stands_level_with_equal_loads_on_a_slope) {
  for (const double slope_rad : {0.0, 0.26}) {
    const auto ground = test::moon(slope_rad, 0.7);
    const VehicleConfig config = vehicle();
    Vehicle v(config, *ground);
    ASSERT_EQ(v.place(ground->site().origin(), 0.3), "") << slope_rad;
    EXPECT_LT(tilt_rad(v), 0.005) << slope_rad;
    EXPECT_FALSE(v.is_adjusting());
    const double g_mps2 = ground->site().gravity_S_mps2(Vec3::Zero()).norm();
    const double share_n = config.mass_kg() * g_mps2 / 6;
    double sum_n = 0;
    for (const double load_n : loads_n(v)) sum_n += load_n;
    // Along the normal of a slope only its cosine's part, the rest is friction.
    EXPECT_NEAR(sum_n, 6 * share_n, 0.04 * 6 * share_n) << slope_rad;
    for (const double load_n : loads_n(v)) EXPECT_NEAR(load_n / share_n, 1, 0.2) << slope_rad;
  }
}

TEST(Legged, lies_as_the_ground_does_without_levelling) {
  RoverSpec spec = test::rover_on_limbs();
  spec.configurations = {{.name = "Passive", .is_level = false}};
  const auto ground = test::moon(0.26, 0.7);
  Vehicle passive(vehicle(spec, "Passive"), *ground);
  ASSERT_EQ(passive.place(ground->site().origin(), 0.3), "");
  EXPECT_NEAR(tilt_rad(passive), 0.26, 0.02);

  std::get<Legged>(spec.suspension).posture.reset();
  Vehicle without(vehicle(spec), *ground);
  ASSERT_EQ(without.place(ground->site().origin(), 0.3), "");
  EXPECT_NEAR(tilt_rad(without), 0.26, 0.02);
}

TEST(Legged, parked_on_a_slope_it_does_not_creep) {
  const auto ground = test::moon(0.26, 0.7);
  Vehicle v(vehicle(), *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0.3), "");
  test::settle(v);
  const Vec3 before_m = v.report().p_S_m;
  const std::vector<double> joints = v.joint_positions();
  for (int i = 0; i < 600; ++i) v.advance(exchange_period);
  EXPECT_LT((v.report().p_S_m - before_m).norm(), 1e-5);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    EXPECT_NEAR(v.joint_positions()[i], joints[i], 1e-5) << i;
  }
  EXPECT_EQ(v.drive_w(), 0);
}

TEST(Legged, moves_to_another_height_in_the_time_given_and_uses_power_for_it) {
  const auto ground = test::moon();
  const VehicleConfig config = vehicle();
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  const auto chassis_m = [&] { return v.part_poses().front().p_S_m.z(); };
  const double before_m = chassis_m(), before_j = v.drive_j();
  v.set_posture(at_height(config, v.posture()->hubs_B_m(), 1.0), true, 10);
  for (int i = 0; i < 50; ++i) v.advance(exchange_period);
  EXPECT_NEAR(chassis_m() - before_m, 0.1, 0.02);
  EXPECT_TRUE(v.is_adjusting());
  for (int i = 0; i < 100; ++i) v.advance(exchange_period);
  EXPECT_NEAR(chassis_m() - before_m, 0.2, 0.005);
  EXPECT_FALSE(v.is_adjusting());
  // At least the work of lifting, through gears of one half.
  const double lifted_j = 0.2 * 400 * ground->site().gravity_S_mps2(Vec3::Zero()).norm();
  EXPECT_GT(v.drive_j() - before_j, lifted_j / 0.5);
  EXPECT_LT(v.drive_j() - before_j, 20 * lifted_j);
  EXPECT_NEAR(v.report().p_S_m.z(), 0, 0.05);  // the reference point stays on the ground
}

TEST(Legged, a_pose_between_two_stances_is_state) {
  const auto ground = test::moon(0.1, 0.4);
  const VehicleConfig config = vehicle();
  Vehicle v(config, *ground), restored(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  v.set_posture(at_height(config, v.posture()->hubs_B_m(), 1.0), true, 10);
  for (int i = 0; i < 37; ++i) v.advance(exchange_period);
  Archive writer = Archive::writer();
  v.archive(writer);
  Archive reader = Archive::reader(writer.bytes());
  restored.archive(reader);
  for (int i = 0; i < 100; ++i) {
    v.advance(exchange_period);
    restored.advance(exchange_period);
  }
  EXPECT_EQ(v.joint_positions(), restored.joint_positions());
  EXPECT_EQ(v.drive_j(), restored.drive_j());
}

TEST(Legged, energy_closes_while_it_moves) {
  const auto ground = test::moon(0.1, 0.4);
  const VehicleConfig config = vehicle();
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  const double before_j = v.kinetic_j() + v.potential_j();
  v.command({.speed_mps = 0.3, .is_braking = false});
  for (int i = 0; i < 100; ++i) v.advance(exchange_period);
  const double change_j = v.kinetic_j() + v.potential_j() - before_j;
  EXPECT_NEAR(v.work().sum_j(), change_j, 0.02 * std::abs(v.work().limbs_j) + 3);
}

TEST(Legged, a_locked_joint_holds_its_angle) {
  const auto ground = test::moon();
  const VehicleConfig config = vehicle();
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  v.set_limb_locked(2, true);  // limb_1_knee
  const double before_rad = v.limb_angles_rad()[0][2];
  v.set_posture(at_height(config, v.posture()->hubs_B_m(), 0.95), true, 5);
  for (int i = 0; i < 100; ++i) v.advance(exchange_period);
  EXPECT_NEAR(v.limb_angles_rad()[0][2], before_rad, 0.01);
  EXPECT_LT(tilt_rad(v), 0.03);  // the others keep it level
}

}  // namespace
}  // namespace lsos
