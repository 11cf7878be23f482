#include "vehicle/suspension/rocker_bogie.h"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "test_rovers.h"
#include "test_site.h"
#include "vehicle/suspension/link_parts.h"
#include "vehicle/vehicle.h"
#include "wheel_loads.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

VehicleConfig vehicle_of(const RockerBogie& suspension) {
  VehicleConfig vehicle = test::small_body();
  add_rocker_bogie(vehicle, suspension);
  return vehicle;
}

int link_number(const VehicleConfig& vehicle, const std::string& name) {
  const auto found = std::ranges::find(vehicle.links, name, &LinkConfig::name);
  return found == vehicle.links.end() ? -1 : static_cast<int>(found - vehicle.links.begin());
}

// Rockers without bogies, wheels 0.5 m before and behind the pivot.
RockerBogie four_wheeled_bogie() {
  RockerBogie s = test::rocker_bogie();
  s.bogie.reset();
  s.stations = {{"front", {0.5, 0.5}, true, true, Arm::rocker},
                {"rear", {-0.5, 0.5}, true, true, Arm::rocker}};
  s.rocker = test::arm({0, 0.4, 0.4}, 6);
  return s;
}

TEST(RockerBogie, names_its_links_and_mirrors_its_right_side) {
  const VehicleConfig vehicle = vehicle_of(test::rocker_bogie());
  std::vector<std::string> names;
  for (const LinkConfig& link : vehicle.links) names.push_back(link.name);
  EXPECT_THAT(
      names, ElementsAre("rocker_left", "bogie_left", "front_left_steering", "front_left_wheel",
                         "middle_left_wheel", "rear_left_steering", "rear_left_wheel",
                         "rocker_right", "bogie_right", "front_right_steering", "front_right_wheel",
                         "middle_right_wheel", "rear_right_steering", "rear_right_wheel"));
  for (std::size_t i = 0; i < 7; ++i) {
    const Vec3 left = joint_at_rest_B_m(vehicle, static_cast<int>(i));
    const Vec3 right = joint_at_rest_B_m(vehicle, static_cast<int>(i) + 7);
    EXPECT_LT((left.cwiseProduct(Vec3(1, -1, 1)) - right).norm(), 1e-12) << names[i];
    EXPECT_EQ(vehicle.links[i].p_JC_m.cwiseProduct(Vec3(1, -1, 1)), vehicle.links[i + 7].p_JC_m);
  }
  EXPECT_LT((joint_at_rest_B_m(vehicle, 6) - Vec3(-0.6, 0.5, 0.15)).norm(), 1e-12);
}

TEST(RockerBogie, weighs_what_its_parts_weigh) {
  // Chassis 120 kg, differential 5 kg; on each side a rocker of 6 kg, a bogie of 4 kg, two knuckles
  // and three wheels of 2 kg each.
  const VehicleConfig vehicle = vehicle_of(test::rocker_bogie());
  EXPECT_DOUBLE_EQ(vehicle.mass_kg(), 120 + 5 + 2 * (6 + 4 + 2 * 2 + 3 * 2));
  EXPECT_DOUBLE_EQ(vehicle.chassis.mass_kg, 125);
  EXPECT_NEAR(vehicle.p_BC_m.x(), (120 * 0.05 - 5 * 0.1) / 125, 1e-12);
  EXPECT_NEAR(vehicle.p_BC_m.z(), (120 * 0.5 + 5 * 0.6) / 125, 1e-12);
}

TEST(RockerBogie, spreads_an_arm_between_what_it_joins) {
  RockerBogie s = four_wheeled_bogie();
  const VehicleConfig vehicle = vehicle_of(s);
  // Pivot (0, 0.4, 0.4), hubs (0.5, 0.5, 0.15) and (-0.5, 0.5, 0.15).
  EXPECT_LT((vehicle.links[0].p_JC_m - Vec3(0, 0.2 / 3, -0.5 / 3)).norm(), 1e-12);
  // A box of 1 x 0.2 x 0.25 m: its width is at least a fifth of its length.
  EXPECT_NEAR(vehicle.links[0].inertia.moments_kgm2.y(), 6.0 / 12 * (1 + 0.25 * 0.25), 1e-12);
  EXPECT_NEAR(vehicle.links[0].inertia.moments_kgm2.z(), 6.0 / 12 * (1 + 0.2 * 0.2), 1e-12);
}

TEST(RockerBogie, shares_its_weight_by_the_lever_law) {
  const VehicleConfig config = vehicle_of(test::rocker_bogie());
  const auto ground = test::moon();
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  test::settle(vehicle);
  // Balance of one side: forces; moments about x = 0; moments about the bogie's pivot, x = -0.2,
  // where its own weight acts. Masses: half of the chassis at 0.05 and of the differential at -0.1,
  // the rocker at 0.2, the bogie at -0.2; wheels with knuckles 4 kg front and rear, 2 kg in the
  // middle.
  const double half_kg = 60 + 2.5 + 6 + 4 + 4 + 2 + 4;
  const double moment_kgm =
      60 * 0.05 + 2.5 * -0.1 + 6 * 0.2 + 4 * -0.2 + 4 * 0.7 + 2 * 0.1 + 4 * -0.6;
  Mat3 levers;
  levers << 1, 1, 1, 0.7, 0.1, -0.6, 0, 0.3, -0.4;
  const Vec3 loads_n =
      levers.inverse() * (test::moon_g_mps2 * Vec3(half_kg, moment_kgm, 2 * 0.3 - 4 * 0.4));
  const std::map<std::string, double> found_n = test::wheel_loads_n(vehicle);
  ASSERT_EQ(found_n.size(), 6u);
  for (const char* side : {"left", "right"}) {
    const auto load_n = [&](const char* station) {
      return found_n.at(std::string(station) + "_" + side + "_wheel");
    };
    EXPECT_NEAR(load_n("front"), loads_n.x(), 0.01 * loads_n.x());
    EXPECT_NEAR(load_n("middle"), loads_n.y(), 0.01 * loads_n.y());
    EXPECT_NEAR(load_n("rear"), loads_n.z(), 0.01 * loads_n.z());
  }
  EXPECT_NEAR(test::sum(found_n), config.mass_kg() * test::moon_g_mps2,
              1e-3 * config.mass_kg() * test::moon_g_mps2);
}

// A wheel of larger radius replaces a wheel on a block.
TEST(RockerBogie, chassis_pitches_by_the_mean_of_its_rockers) {
  constexpr double block_m = 0.08;
  VehicleConfig config = vehicle_of(four_wheeled_bogie());
  const int front_left = link_number(config, "front_left_wheel");
  config.links[static_cast<std::size_t>(front_left)].wheel->radius_m += block_m;
  const auto ground = test::moon();
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  const std::vector<double> joints = vehicle.joint_positions();
  const double left = joints[static_cast<std::size_t>(link_number(config, "rocker_left"))];
  const double right = joints[static_cast<std::size_t>(link_number(config, "rocker_right"))];
  // The hubs of the left rocker differ in height by the block over 1 m, those of the right one do
  // not. Joint angles are positive with the front end down, pitch with the nose up.
  const double pitch_rad = std::asin(block_m) / 2;
  EXPECT_NEAR(vehicle.report().pitch_rad, pitch_rad, 2e-3);
  EXPECT_NEAR(left - right, -std::asin(block_m), 2e-3);
  EXPECT_NEAR(left + right, 0, 2e-3);
  EXPECT_NEAR(test::sum(test::wheel_loads_n(vehicle)), config.mass_kg() * test::moon_g_mps2, 1);
}

TEST(RockerBogie, bogie_follows_the_ground_alone) {
  VehicleConfig config = vehicle_of(test::rocker_bogie());
  for (const char* name : {"middle_left_wheel", "middle_right_wheel"}) {
    config.links[static_cast<std::size_t>(link_number(config, name))].wheel->radius_m += 0.05;
  }
  const auto ground = test::moon();
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  const std::vector<double> joints = vehicle.joint_positions();
  // The middle hubs are 5 cm up, 0.7 m before the rear ones: bogies tilt by that angle in all.
  // Their pivots rise by 4/7 of 5 cm, 0.9 m behind the front hubs, so the rover pitches nose down.
  const double rocker_rad = std::asin(0.05 * 4 / 7 / 0.9);
  const double bogie = joints[static_cast<std::size_t>(link_number(config, "bogie_left"))];
  EXPECT_NEAR(vehicle.report().pitch_rad, -rocker_rad, 3e-3);
  EXPECT_NEAR(bogie, -std::asin(0.05 / 0.7) - rocker_rad, 5e-3);
}

TEST(RockerBogie, wheels_without_a_motor_turn_freely) {
  RockerBogie s = test::rocker_bogie();
  s.stations[1].is_driven = false;
  const VehicleConfig config = vehicle_of(s);
  for (const LinkConfig& link : config.links) {
    EXPECT_EQ(link.wheel_mode,
              link.name.starts_with("middle") ? WheelMode::free : WheelMode::driven);
  }
}

TEST(RockerBogieFaults, say_what_does_not_stand) {
  const auto faults = [](const auto& change) {
    RockerBogie s = test::rocker_bogie();
    change(s);
    std::string text;
    for (const std::string& fault : rocker_bogie_faults(s)) text += fault + "\n";
    return text;
  };
  EXPECT_EQ(faults([](RockerBogie&) {}), "");
  EXPECT_EQ(faults([](RockerBogie& s) { s.stations[1].name = "front"; }),
            "two stations are named 'front'\n");
  EXPECT_EQ(faults([](RockerBogie& s) { s.stations[0].p_B_m.y() = 0.04; }),
            "station 'front': the track of 0.08 m is narrower than a wheel, 0.1 m\n");
  EXPECT_THAT(faults([](RockerBogie& s) { s.stations[0].p_B_m.y() = -0.5; }),
              HasSubstr("station 'front': position_m: y = -0.5 is on the right"));
  EXPECT_THAT(faults([](RockerBogie& s) { s.bogie.reset(); }),
              HasSubstr("station 'middle' is on the bogie, but there is no bogie"));
  EXPECT_THAT(faults([](RockerBogie& s) { s.stations[1].arm = Arm::rocker; }),
              HasSubstr("the bogie carries 1 stations: at least 2 are needed"));
  EXPECT_EQ(faults([](RockerBogie& s) { s.bogie->p_B_pivot_m.x() = 0.1; }),
            "the bogie's pivot at x = 0.1 m is not between its stations, -0.6 to 0.1 m: it would "
            "tip over\n");
  EXPECT_EQ(faults([](RockerBogie& s) { s.stations[0].arm = Arm::bogie; }),
            "the rocker carries the bogie alone: it needs a station of its own\n");
  EXPECT_EQ(faults([](RockerBogie& s) { s.rocker.p_B_pivot_m.z() = 0; }),
            "the rocker's pivot is not above the ground at rest\n");
  EXPECT_EQ(faults([](RockerBogie& s) { s.bogie->p_B_pivot_m.z() = -0.1; }),
            "the bogie's pivot is not above the ground at rest\n");
  EXPECT_THAT(faults([](RockerBogie& s) { s.stations.clear(); }),
              HasSubstr("0 wheels: at least 3 are needed to stand on"));
}

}  // namespace
}  // namespace lsos
