#include "vehicle/suspension/rover_spec.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

#include "test_rovers.h"

namespace lsos {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string text_of(const std::vector<std::string>& faults) {
  std::string text;
  for (const std::string& fault : faults) text += fault + "\n";
  return text;
}

using Change = std::function<void(RoverSpec&)>;

std::string faults_of(RoverSpec spec, const Change& change) {
  change(spec);
  return text_of(vehicle_faults(spec));
}

RockerBogie& rockers(RoverSpec& spec) { return std::get<RockerBogie>(spec.suspension); }

const LinkConfig& link_named(const VehicleConfig& vehicle, const std::string& name) {
  return *std::ranges::find(vehicle.links, name, &LinkConfig::name);
}

TEST(MakeVehicle, builds_each_kind_of_suspension) {
  EXPECT_EQ(make_vehicle(test::wishbone_rover(), "", 1.6).links.size(), 24u);
  EXPECT_EQ(make_vehicle(test::rocker_bogie_rover(), "", 1.6).links.size(), 14u);
  EXPECT_EQ(make_vehicle(test::skid_steer_rover(), "", 1.6).links.size(), 4u);
}

TEST(MakeVehicle, says_how_drive_energy_is_calibrated) {
  RoverSpec spec = test::skid_steer_rover();
  EXPECT_THAT(make_vehicle(spec, "", 1).assumptions,
              Contains("Small: drive energy is multiplied by 1 (drive_calibration): not calibrated "
                       "against field data"));
  spec.vehicle.drive_calibration = 1.3;
  spec.vehicle.drive_calibration_source = "yard tests of 2009";
  EXPECT_THAT(make_vehicle(spec, "", 1).assumptions,
              Contains("Small: drive energy is multiplied by 1.3 (drive_calibration): yard tests "
                       "of 2009"));
}

TEST(MakeVehicle, applies_a_configuration) {
  RoverSpec spec = test::rocker_bogie_rover();
  spec.configurations = {{.name = "Limp",
                          .joints = {{"front_left_steering", 0.3}, {"bogie_right", -0.2}},
                          .free_wheels = {"rear_left_wheel"},
                          .locked_wheels = {"front_right_wheel"}}};
  const VehicleConfig vehicle = make_vehicle(spec, "Limp", 1.6);
  EXPECT_EQ(link_named(vehicle, "front_left_steering").initial, 0.3);
  EXPECT_EQ(link_named(vehicle, "bogie_right").initial, -0.2);
  EXPECT_EQ(link_named(vehicle, "bogie_left").initial, 0);
  EXPECT_EQ(link_named(vehicle, "rear_left_wheel").wheel_mode, WheelMode::free);
  EXPECT_EQ(link_named(vehicle, "front_right_wheel").wheel_mode, WheelMode::locked);
  EXPECT_EQ(link_named(vehicle, "front_left_wheel").wheel_mode, WheelMode::driven);
  const VehicleConfig plain = make_vehicle(spec, "", 1.6);
  EXPECT_EQ(link_named(plain, "front_right_wheel").wheel_mode, WheelMode::driven);
  EXPECT_THAT(vehicle_faults(spec), IsEmpty());
}

TEST(MakeVehicle, adds_a_payload_by_parallel_axes) {
  RoverSpec spec = test::wishbone_rover();  // 3000 kg, {4000, 6000, 8000} kg m2, at 1.2 m
  spec.configurations = {{.name = "Loaded", .payload_mass_kg = 1000, .p_BP_m = {1, 0, 2}},
                         {.name = "Light", .payload_mass_kg = -1000, .p_BP_m = {0, 0, 1.2}}};
  const VehicleConfig loaded = make_vehicle(spec, "Loaded", 1.6);
  EXPECT_DOUBLE_EQ(loaded.mass_kg(), 3840 + 1000);
  EXPECT_LT((loaded.p_BC_m - Vec3(0.25, 0, 1.4)).norm(), 1e-12);
  // Both masses about their common centre: 3000 x 1000 / 4000 = 750 kg at a distance (1, 0, 0.8).
  EXPECT_NEAR(loaded.chassis.moments_kgm2.x(), 4000 + 750 * 0.64, 1e-9);
  EXPECT_NEAR(loaded.chassis.moments_kgm2.y(), 6000 + 750 * 1.64, 1e-9);
  EXPECT_NEAR(loaded.chassis.moments_kgm2.z(), 8000 + 750 * 1.0, 1e-9);
  // Springs are preset for the payload.
  double preload_n = 0;
  for (const LinkConfig& link : loaded.links) preload_n += link.spring ? link.spring->preload : 0;
  EXPECT_NEAR(preload_n, -4000 * 1.6, 1e-9);

  const VehicleConfig light = make_vehicle(spec, "Light", 1.6);
  EXPECT_DOUBLE_EQ(light.mass_kg(), 3840 - 1000);
  EXPECT_EQ(light.p_BC_m, Vec3(0, 0, 1.2));
  EXPECT_EQ(light.chassis.moments_kgm2, Vec3(4000, 6000, 8000));
}

TEST(VehicleFaults, are_none_of_a_sound_rover) {
  EXPECT_THAT(vehicle_faults(test::wishbone_rover()), IsEmpty());
  EXPECT_THAT(vehicle_faults(test::rocker_bogie_rover()), IsEmpty());
  EXPECT_THAT(vehicle_faults(test::skid_steer_rover()), IsEmpty());
  RoverSpec spec = test::skid_steer_rover();
  SkidSteer& suspension = std::get<SkidSteer>(spec.suspension);
  suspension.rocker = test::arm({0, 0.25, 0.3}, 4);
  suspension.differential = Differential{
      .p_B_m = {0, 0, 0.5}, .mass_kg = 2, .stiffness_n_m_prad = 3000, .damping_n_m_sprad = 40};
  EXPECT_THAT(vehicle_faults(spec), IsEmpty());
}

TEST(VehicleFaults, tell_of_wheels_and_balance) {
  const RoverSpec spec = test::rocker_bogie_rover();
  EXPECT_THAT(faults_of(spec,
                        [](RoverSpec& s) {
                          rockers(s).stations[1].p_B_m = {0.5, 0.5};
                        }),
              HasSubstr("front_left_wheel and middle_left_wheel overlap: 0.200 m apart along and "
                        "0.000 m across; 0.300 m along or 0.100 m across is needed"));
  EXPECT_EQ(faults_of(spec, [](RoverSpec& s) { s.vehicle.chassis_clearance_m = 0; }),
            "the chassis' underside is not above the ground at rest\n");
  EXPECT_EQ(faults_of(spec, [](RoverSpec& s) { s.vehicle.p_BC_m.z() = -0.1; }),
            "the chassis' centre of mass is not above the ground at rest\n");
  EXPECT_THAT(faults_of(spec, [](RoverSpec& s) { s.vehicle.p_BC_m.x() = 1.5; }),
              HasSubstr("is not over its wheels: it would tip over at rest"));
  EXPECT_THAT(faults_of(test::wishbone_rover(),
                        [](RoverSpec& s) {
                          std::get<Wishbone>(s.suspension).wheel_offsets_m = {0.1, -0.1};
                        }),
              HasSubstr("front_left_wheel_1 and front_left_wheel_2 overlap: 0.000 m apart along "
                        "and 0.200 m across"));
  EXPECT_THAT(faults_of(test::wishbone_rover(),
                        [](RoverSpec& s) {
                          for (auto& module : std::get<Wishbone>(s.suspension).modules) {
                            module.p_B_m.y() *= 0.08;
                          }
                          std::get<Wishbone>(s.suspension).wheel_offsets_m = {0.0};
                        }),
              HasSubstr("front_left_wheel_1 and front_right_wheel_1: the track of 0.240 m is "
                        "narrower than a wheel"));
}

// The wheels of the rockers hold a rocker-bogie up in front: with its centre of mass behind the
// bogies' pivots it tips over although there are wheels behind.
TEST(VehicleFaults, tell_of_balance_on_bogies) {
  EXPECT_THAT(
      faults_of(test::rocker_bogie_rover(), [](RoverSpec& s) { s.vehicle.p_BC_m.x() = -0.5; }),
      HasSubstr("is not between the rockers' wheels and the bogies' pivots, -0.200 to "
                "0.700 m: it would tip over at rest"));
}

TEST(VehicleFaults, tell_of_abilities_that_are_not_there) {
  const RoverSpec spec = test::rocker_bogie_rover();
  EXPECT_EQ(faults_of(spec, [](RoverSpec& s) { s.vehicle.can_crab = true; }),
            "can_crab: not all of its wheels are steered\n");
  EXPECT_EQ(faults_of(test::wishbone_rover(),
                      [](RoverSpec& s) {
                        s.vehicle.can_crab = true;
                        std::get<Wishbone>(s.suspension).steering.angle_max_rad = 1.5;
                      }),
            "can_crab: its steering does not reach 90 deg either way\n");
  EXPECT_EQ(faults_of(test::skid_steer_rover(), [](RoverSpec& s) { s.vehicle.can_crab = true; }),
            "can_crab: not all of its wheels are steered\n");
  EXPECT_THAT(faults_of(spec,
                        [](RoverSpec& s) {
                          s.vehicle.can_turn_on_spot = true;
                          rockers(s).steering.angle_max_rad = 0.8;
                        }),
              HasSubstr("can_turn_on_spot: front_left_steering would have to steer by 50 deg, its "
                        "angle_max_rad is 46 deg"));
  EXPECT_THAT(faults_of(spec,
                        [](RoverSpec& s) {
                          s.vehicle.turning_radius_min_m = 1;
                          rockers(s).steering.angle_max_rad = 0.5;
                        }),
              HasSubstr("turning_radius_min_m = 1: front_left_steering would have to steer by"));
  EXPECT_THAT(faults_of(spec,
                        [](RoverSpec& s) {
                          for (WheelStation& station : rockers(s).stations) {
                            station.is_steered = false;
                          }
                        }),
              HasSubstr("no wheel is steered: lsos.skid_steer is for rovers that turn without"));
  EXPECT_THAT(faults_of(spec, [](RoverSpec& s) { rockers(s).drive.no_load_speed_radps = 2; }),
              HasSubstr("no_load_speed_radps = 2: speed_max_mps needs more than 2.000 rad/s"));
}

TEST(VehicleFaults, tell_of_grousers_and_calibration) {
  const RoverSpec spec = test::rocker_bogie_rover();
  EXPECT_EQ(faults_of(spec, [](RoverSpec& s) { rockers(s).wheel.grouser_height_m = 0.01; }),
            "the wheel has a grouser_height_m but no grouser_count\n");
  EXPECT_EQ(faults_of(spec, [](RoverSpec& s) { rockers(s).wheel.grouser_count = 12; }),
            "the wheel has a grouser_count but no grouser_height_m\n");
  EXPECT_EQ(faults_of(spec,
                      [](RoverSpec& s) {
                        rockers(s).wheel.grouser_height_m = 0.2;
                        rockers(s).wheel.grouser_count = 12;
                      }),
            "grouser_height_m = 0.2: must be less than the wheel's radius, 0.15 m\n");
  EXPECT_EQ(faults_of(spec, [](RoverSpec& s) { s.vehicle.drive_calibration = 1.2; }),
            "drive_calibration = 1.2: needs a drive_calibration_source\n");
}

TEST(VehicleFaults, tell_of_a_step_too_long) {
  const RoverSpec spec = test::rocker_bogie_rover();
  // The normal spring with the wheel's 2 kg alone: 5 ms x sqrt(k / 2 kg) = 1.5.
  EXPECT_THAT(faults_of(spec, [](RoverSpec& s) { rockers(s).wheel.normal_stiffness_npm = 1.8e5; }),
              HasSubstr("step_s = 0.005: too long for the wheel's normal spring of "
                        "front_left_wheel: omega x step is 1.50, at most 1 is stable; a step of "
                        "0.0033 s or less, or a softer spring"));
  EXPECT_THAT(
      faults_of(spec, [](RoverSpec& s) { rockers(s).differential.stiffness_n_m_prad = 1e6; }),
      HasSubstr("too long for the differential of rocker_left: omega x step is"));
  EXPECT_THAT(
      faults_of(spec, [](RoverSpec& s) { rockers(s).differential.damping_n_m_sprad = 1e4; }),
      HasSubstr("too long for the differential of rocker_left: damping x step / inertia is"));
  EXPECT_THAT(faults_of(spec, [](RoverSpec& s) { rockers(s).drive.servo_gain_n_m_sprad = 100; }),
              HasSubstr("too long for the drive servo of front_left_wheel: damping x step"));
  EXPECT_THAT(faults_of(spec, [](RoverSpec& s) { rockers(s).wheel.tangential_damping_nspm = 1e4; }),
              HasSubstr("too long for the wheel's tangential damper of front_left_wheel"));
  EXPECT_THAT(faults_of(spec, [](RoverSpec& s) { rockers(s).steering.stiffness_n_m_prad = 1e5; }),
              HasSubstr("too long for the steering servo of front_left_steering"));
  EXPECT_THAT(
      faults_of(spec, [](RoverSpec& s) { rockers(s).bogie->stop_stiffness_n_m_prad = 1e6; }),
      HasSubstr("too long for the suspension's stops of bogie_left"));
  EXPECT_THAT(
      faults_of(spec, [](RoverSpec& s) { rockers(s).drive.brake_stiffness_n_m_prad = 1e5; }),
      HasSubstr("too long for the brake of front_left_wheel"));
}

std::string configuration_faults(const RoverConfiguration& configuration) {
  return faults_of(test::rocker_bogie_rover(),
                   [&](RoverSpec& s) { s.configurations = {configuration}; });
}

TEST(VehicleFaults, tell_of_configurations) {
  EXPECT_EQ(configuration_faults({.name = "A", .joints = {{"rocker_lft", 0.1}}}),
            "configuration 'A': no joint 'rocker_lft'; did you mean 'rocker_left'?\n");
  EXPECT_THAT(configuration_faults({.name = "A", .joints = {{"elbow", 0.1}}}),
              HasSubstr("configuration 'A': no joint 'elbow'; it has rocker_left, bogie_left, "
                        "front_left_steering"));
  EXPECT_EQ(configuration_faults({.name = "A", .joints = {{"bogie_left", 0.7}}}),
            "configuration 'A': bogie_left = 0.7: must be -0.6..0.6 rad\n");
  EXPECT_EQ(configuration_faults({.name = "A", .joints = {{"rear_right_steering", -1.3}}}),
            "configuration 'A': rear_right_steering = -1.3: must be -1.2..1.2 rad\n");
  EXPECT_EQ(configuration_faults({.name = "A", .locked_wheels = {"front_left"}}),
            "configuration 'A': no wheel 'front_left'; it has front_left_wheel, "
            "middle_left_wheel, rear_left_wheel, front_right_wheel, middle_right_wheel, "
            "rear_right_wheel\n");
  EXPECT_EQ(configuration_faults({.name = "A", .free_wheels = {"rear_left_whel"}}),
            "configuration 'A': no wheel 'rear_left_whel'; did you mean 'rear_left_wheel'?\n");
  EXPECT_EQ(
      configuration_faults(
          {.name = "A", .free_wheels = {"rear_left_wheel"}, .locked_wheels = {"rear_left_wheel"}}),
      "configuration 'A': wheel 'rear_left_wheel' is named twice in free_wheels and "
      "locked_wheels\n");
  EXPECT_EQ(configuration_faults({.name = "A", .payload_mass_kg = -200}),
            "configuration 'A': payload_mass_kg = -200: the chassis has only 120 kg to take off\n");
  EXPECT_THAT(configuration_faults({.name = "A", .payload_mass_kg = -60, .p_BP_m = {0.05, 0, 1.5}}),
              HasSubstr("the chassis has no such mass at payload_position_m to take off"));
  EXPECT_THAT(configuration_faults({.name = "A", .payload_mass_kg = 500, .p_BP_m = {2, 0, 1}}),
              HasSubstr("configuration 'A': the centre of mass of the whole"));
  EXPECT_EQ(faults_of(test::rocker_bogie_rover(),
                      [](RoverSpec& s) {
                        s.configurations = {{.name = "A"}, {.name = "A"}};
                      }),
            "two configurations are named 'A'\n");
}

}  // namespace
}  // namespace lsos
