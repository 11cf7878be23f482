#include "vehicle/suspension/legged.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

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

VehicleConfig legged_vehicle(const RoverSpec& spec = test::rover_on_limbs(),
                             const std::string& configuration = "") {
  return make_vehicle(spec, configuration, 1.6);
}

double chassis_tilt_rad(Vehicle& legged_vehicle) {
  const VehicleReport report = legged_vehicle.report();
  return std::acos(std::cos(report.pitch_rad) * std::cos(report.roll_rad));
}

std::vector<double> loads_n(const Vehicle& legged_vehicle) {
  std::vector<double> loads;
  for (std::size_t i = 0; i < 6; ++i) loads.push_back(legged_vehicle.wheel_load_n(i));
  return loads;
}

TEST(Legged, builds_a_chain_for_each_limb) {
  const VehicleConfig v = legged_vehicle();
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
    const VehicleConfig config = legged_vehicle();
    Vehicle v(config, *ground);
    ASSERT_EQ(v.place(ground->site().origin(), 0.3), "") << slope_rad;
    EXPECT_LT(chassis_tilt_rad(v), 0.005) << slope_rad;
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
  Vehicle passive(legged_vehicle(spec, "Passive"), *ground);
  ASSERT_EQ(passive.place(ground->site().origin(), 0.3), "");
  EXPECT_NEAR(chassis_tilt_rad(passive), 0.26, 0.02);

  std::get<Legged>(spec.suspension).posture.reset();
  Vehicle without(legged_vehicle(spec), *ground);
  ASSERT_EQ(without.place(ground->site().origin(), 0.3), "");
  EXPECT_NEAR(chassis_tilt_rad(without), 0.26, 0.02);
}

TEST(Legged, parked_on_a_slope_it_does_not_creep) {
  const auto ground = test::moon(0.26, 0.7);
  Vehicle v(legged_vehicle(), *ground);
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
  const VehicleConfig config = legged_vehicle();
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
  const VehicleConfig config = legged_vehicle();
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
  const VehicleConfig config = legged_vehicle();
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
  const VehicleConfig config = legged_vehicle();
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  v.set_limb_locked(2, true);  // limb_1_knee
  const std::vector<double> before_rad = v.joint_positions();
  v.set_posture(at_height(config, v.posture()->hubs_B_m(), 0.95), true, 5);
  for (int i = 0; i < 100; ++i) v.advance(exchange_period);
  const std::vector<double> after_rad = v.joint_positions();
  EXPECT_NEAR(after_rad[2], before_rad[2], 0.01);
  for (std::size_t limb = 1; limb < 6; ++limb) {
    const std::size_t knee = 5 * limb + 2;
    EXPECT_GT(std::abs(after_rad[knee] - before_rad[knee]), 0.05) << limb;
  }
  EXPECT_LT(chassis_tilt_rad(v), 0.03);  // the others keep it level
}

TEST(Legged, a_limb_that_is_repaired_goes_on_while_it_stands) {
  const auto ground = test::moon();
  const VehicleConfig config = legged_vehicle();
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  v.set_limb_locked(2, true);
  const double before_rad = v.joint_positions()[2];
  v.set_posture(at_height(config, v.posture()->hubs_B_m(), 1.0), true, 5);
  for (int i = 0; i < 1000 && v.is_adjusting(); ++i) v.advance(exchange_period);
  ASSERT_FALSE(v.is_adjusting());
  v.set_limb_locked(2, false);
  EXPECT_TRUE(v.is_adjusting());
  for (int i = 0; i < 1000 && v.is_adjusting(); ++i) v.advance(exchange_period);
  EXPECT_GT(std::abs(v.joint_positions()[2] - before_rad), 0.05);
  EXPECT_LT(chassis_tilt_rad(v), 0.005);
}

// The power is that of the work that is done: a motor that only holds loses heat in its windings.
TEST(Legged, a_joint_that_stalls_takes_no_power_for_work_that_it_does_not_do) {
  const auto ground = test::moon();
  VehicleConfig config = legged_vehicle();
  for (LinkConfig& link : config.links) {
    if (link.limb) link.limb->motor.torque_max_n_m = 50;
  }
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  v.set_posture(at_height(config, v.posture()->hubs_B_m(), 1.0), true, 5);
  for (int i = 0; i < 300; ++i) v.advance(exchange_period);
  ASSERT_TRUE(v.is_adjusting());
  // Six limbs of three joints, 1 W of each controller and 50 N m in windings.
  EXPECT_LT(v.drive_w(), 18 * (1 + 1e-5 * 50 * 50) + 1);
}

// A crater as wide as a few wheels under one of them.
std::unique_ptr<Ground> dip(double east_m, double north_m, double depth_m) {
  const Geodetic site{0.1, 0.2, 0};
  const double radius_m = find_body("Moon")->equatorial_radius_m;
  TerrainSpec spec;
  spec.name = "Test";
  spec.layers = {ReliefSurface{site.lon_rad,
                               site.lat_rad,
                               0,
                               0.1,
                               {{"dip", site.lon_rad + east_m / (radius_m * std::cos(site.lat_rad)),
                                 site.lat_rad + north_m / radius_m, 2.4, depth_m, 0}}}};
  spec.soil = test::soil();
  return std::make_unique<Ground>(spec, SiteFrame(*find_body("Moon"), site), 0);
}

TEST(Legged, is_put_down_with_each_wheel_on_its_own_ground) {
  // limb_1 stands 2 m from the middle, 30 degrees to the left of ahead.
  const auto ground = dip(-1, 1.73, 0.3);
  Vehicle v(legged_vehicle(), *ground);
  ASSERT_EQ(v.put_down(ground->site().origin(), 0), "");
  const double before_m = v.part_poses().front().p_S_m.z();
  double fastest_mps = 0, lowest_m = before_m;
  for (int i = 0; i < 30; ++i) {
    v.advance(exchange_period);
    fastest_mps = std::max(fastest_mps, std::abs(v.report().v_S_mps.z()));
    lowest_m = std::min(lowest_m, v.part_poses().front().p_S_m.z());
  }
  // Wheels and soil give way by a few centimetres.
  EXPECT_LT(before_m - lowest_m, 0.06);
  EXPECT_LT(fastest_mps, 0.15);
  EXPECT_LT(chassis_tilt_rad(v), 0.02);
  EXPECT_GT(v.wheel_load_n(0), 0.3 * v.wheel_load_n(1));
}

// One wheel hangs in it, at the end of its limb: the chassis does not go down after it. The mean of
// the hubs keeps the height, so that it lowers the chassis by a sixth of what it is lower.
TEST(Legged, does_not_lower_its_chassis_for_a_wheel_over_a_hole) {
  const auto ground = dip(-1, 1.73, 4);
  Vehicle v(legged_vehicle(), *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  EXPECT_EQ(v.wheel_load_n(0), 0);
  EXPECT_LT(chassis_tilt_rad(v), 0.03);
  const double low_m = v.posture()->hubs_B_m()[0].z() - v.hubs_B_m()[0].z();
  EXPECT_GT(low_m, 0.5);
  const double sunk_m = -v.part_poses().front().p_S_m.z();
  EXPECT_NEAR(sunk_m, low_m / 5, 0.15);
}

TEST(Legged, settles_until_its_limbs_no_longer_move) {
  RoverSpec spec = test::rover_on_limbs();
  // Slow joints take more than the 20 s that springs have.
  for (Limb& limb : std::get<Legged>(spec.suspension).limbs) {
    for (LimbJoint& joint : limb.joints) joint.actuator.motor.rate_max_radps = 2e-3;
  }
  const auto ground = dip(-1, 1.73, 0.3);
  Vehicle v(legged_vehicle(spec), *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  EXPECT_FALSE(v.is_adjusting());
}

// The hips of a configuration may turn its wheels aside; steering makes up for it.
TEST(Legged, drives_straight_in_a_stance_whose_joints_turn_its_wheels) {
  RoverSpec spec = test::rover_on_limbs();
  RoverConfiguration turned{.name = "Turned"};
  for (int i = 1; i <= 6; ++i) turned.joints["limb_" + std::to_string(i) + "_yaw"] = 0.4;
  spec.configurations = {turned};
  ASSERT_THAT(vehicle_faults(spec), IsEmpty());
  const auto ground = test::moon();
  const auto drive_j = [&](const std::string& configuration) {
    Vehicle v(legged_vehicle(spec, configuration), *ground);
    EXPECT_EQ(v.place(ground->site().origin(), 0), "");
    v.command({.speed_mps = 0.3, .is_braking = false});
    for (int i = 0; i < 50; ++i) v.advance(exchange_period);
    const double before_j = v.drive_j(), before_m = v.distance_m();
    for (int i = 0; i < 200; ++i) v.advance(exchange_period);
    const VehicleReport report = v.report();
    EXPECT_NEAR(std::remainder(report.heading_rad, 2 * std::numbers::pi), 0, 0.03);
    EXPECT_NEAR(report.p_S_m.x(), 0, 0.2);
    return (v.drive_j() - before_j) / (v.distance_m() - before_m);
  };
  EXPECT_NEAR(drive_j("Turned") / drive_j(""), 1, 0.2);
}

TEST(Legged, on_a_slope_its_incline_is_that_of_the_ground_though_it_is_level) {
  const auto ground = test::moon(0.2, 0);  // falls to the north
  Vehicle v(legged_vehicle(), *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  EXPECT_NEAR(v.report().pitch_rad, 0, 0.01);
  EXPECT_NEAR(v.report().incline_pitch_rad, -0.2, 0.01);
  EXPECT_NEAR(v.report().incline_roll_rad, 0, 0.01);
  ASSERT_EQ(v.place(ground->site().origin(), std::numbers::pi / 2), "");
  EXPECT_NEAR(v.report().incline_pitch_rad, 0, 0.01);
  EXPECT_NEAR(v.report().incline_roll_rad, -0.2, 0.01);
}

// The load stands over the wheels at rest, and without it the stance stands.
TEST(Legged, a_load_is_checked_in_the_stance_of_its_configuration) {
  RoverSpec spec = test::rover_on_limbs();
  RoverConfiguration loaded{.name = "Loaded", .payload_mass_kg = 3000, .p_BP_m = {0, 1.5, 1}};
  spec.configurations = {loaded};
  EXPECT_THAT(vehicle_faults(spec), IsEmpty());
  loaded.joints = {{"limb_1_yaw", -1}, {"limb_2_yaw", 1}, {"limb_3_yaw", 1}};
  spec.configurations = {loaded};
  EXPECT_THAT(vehicle_faults(spec),
              Contains(HasSubstr("configuration 'Loaded': the centre of mass of the whole")));
  loaded.payload_mass_kg = 0;
  spec.configurations = {loaded};
  EXPECT_THAT(vehicle_faults(spec), IsEmpty());
}

}  // namespace
}  // namespace lsos
