#include "vehicle/suspension/skid_steer.h"

#include <gmock/gmock.h>

#include "test_rovers.h"
#include "test_site.h"
#include "vehicle/vehicle.h"
#include "wheel_loads.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;

SkidSteer on_rockers() {
  SkidSteer s = test::skid_steer();
  s.rocker = test::arm({0, 0.25, 0.3}, 4);
  s.differential = test::rocker_bogie().differential;
  s.differential->stiffness_n_m_prad = 3000;
  s.differential->damping_n_m_sprad = 40;
  return s;
}

std::vector<std::string> names_of(const VehicleConfig& vehicle) {
  std::vector<std::string> names;
  for (const LinkConfig& link : vehicle.links) names.push_back(link.name);
  return names;
}

TEST(SkidSteer, puts_its_wheels_on_the_chassis) {
  VehicleConfig vehicle = test::small_body();
  add_skid_steer(vehicle, test::skid_steer());
  EXPECT_THAT(names_of(vehicle), ElementsAre("front_left_wheel", "rear_left_wheel",
                                             "front_right_wheel", "rear_right_wheel"));
  for (const LinkConfig& link : vehicle.links) EXPECT_EQ(link.parent, -1);
  EXPECT_EQ(vehicle.links[3].p_PJ_m, Vec3(-0.4, -0.3, 0.15));
  EXPECT_DOUBLE_EQ(vehicle.mass_kg(), 120 + 4 * 2);
  EXPECT_EQ(vehicle.skid_track_ratio, 1.5);
  EXPECT_TRUE(vehicle.couplings.empty());
}

TEST(SkidSteer, or_on_rockers) {
  VehicleConfig vehicle = test::small_body();
  add_skid_steer(vehicle, on_rockers());
  EXPECT_THAT(names_of(vehicle),
              ElementsAre("rocker_left", "front_left_wheel", "rear_left_wheel", "rocker_right",
                          "front_right_wheel", "rear_right_wheel"));
  EXPECT_EQ(vehicle.couplings.size(), 1u);
  EXPECT_DOUBLE_EQ(vehicle.mass_kg(), 120 + 5 + 2 * 4 + 4 * 2);
  EXPECT_EQ(vehicle.skid_track_ratio, 1.5);
}

TEST(SkidSteer, shares_its_weight_by_the_lever_law) {
  VehicleConfig config = test::small_body();
  add_skid_steer(config, test::skid_steer());
  const auto ground = test::moon();
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  test::settle(vehicle);
  const std::map<std::string, double> loads_n = test::wheel_loads_n(vehicle);
  // The body's 120 kg are at x = 0.05, between axles at 0.4 and -0.4.
  EXPECT_NEAR(loads_n.at("front_left_wheel"), (60 * 0.45 / 0.8 + 2) * test::moon_g_mps2, 0.5);
  EXPECT_NEAR(loads_n.at("rear_right_wheel"), (60 * 0.35 / 0.8 + 2) * test::moon_g_mps2, 0.5);
  EXPECT_NEAR(test::sum(loads_n), 128 * test::moon_g_mps2, 0.2);
}

TEST(SkidSteer, turns_to_the_side_it_is_told) {
  for (const SkidSteer& suspension : {test::skid_steer(), on_rockers()}) {
    VehicleConfig config = test::small_body();
    config.can_turn_on_spot = true;
    add_skid_steer(config, suspension);
    const auto ground = test::moon();
    Vehicle vehicle(config, *ground);
    ASSERT_EQ(vehicle.place(test::start_place, 0), "");
    DriveCommand left;
    left.yaw_rate_radps = 0.1;
    left.is_braking = false;
    const double before_rad = vehicle.report().yaw_rad;
    for (int i = 0; i < 100; ++i) {
      vehicle.command(left);
      vehicle.advance(exchange_period);
    }
    // The turn differs from the command: how much the wheels slide sideways depends on the soil.
    EXPECT_GT(vehicle.report().yaw_rad - before_rad, 0.1);
    EXPECT_LT(vehicle.report().yaw_rad - before_rad, 1);
    EXPECT_LT(vehicle.report().p_S_m.head<2>().norm(), 0.2);
  }
}

TEST(SkidSteerFaults, say_what_does_not_stand) {
  const auto faults = [](SkidSteer s, const auto& change) {
    change(s);
    std::string text;
    for (const std::string& fault : skid_steer_faults(s)) text += fault + "\n";
    return text;
  };
  EXPECT_EQ(faults(test::skid_steer(), [](SkidSteer&) {}), "");
  EXPECT_EQ(faults(on_rockers(), [](SkidSteer&) {}), "");
  EXPECT_EQ(faults(test::skid_steer(), [](SkidSteer& s) { s.stations[0].is_steered = true; }),
            "station 'front' is steered: lsos.skid_steer steers none\n");
  EXPECT_EQ(faults(test::skid_steer(), [](SkidSteer& s) { s.stations[0].arm = Arm::bogie; }),
            "station 'front' is on the bogie: lsos.skid_steer has none\n");
  EXPECT_EQ(faults(on_rockers(), [](SkidSteer& s) { s.differential.reset(); }),
            "the rockers turn freely: they need a differential to hold the chassis\n");
  EXPECT_EQ(faults(on_rockers(), [](SkidSteer& s) { s.rocker.reset(); }),
            "a differential ties rockers, and there is no rocker\n");
  EXPECT_EQ(faults(test::skid_steer(), [](SkidSteer& s) { s.stations[1].p_B_m.y() = 0.01; }),
            "station 'rear': the track of 0.02 m is narrower than a wheel, 0.1 m\n");
}

}  // namespace
}  // namespace lsos
