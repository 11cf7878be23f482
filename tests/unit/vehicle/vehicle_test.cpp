#include "vehicle/vehicle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "test_rover.h"
#include "test_site.h"
#include "vehicle/suspension/vehicle_checks.h"

namespace lsos {
namespace {

void run(Vehicle& vehicle, double duration_s) {
  for (int i = 0; i < static_cast<int>(duration_s * 10); ++i) vehicle.advance(exchange_period);
}

TEST(Vehicle, stands_level_on_level_ground_at_its_ride_height) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, radians(30)), "");
  const VehicleReport report = vehicle.report();
  EXPECT_NEAR(report.heading_rad, radians(30), 1e-6);
  EXPECT_NEAR(report.pitch_rad, 0, 1e-4);
  EXPECT_NEAR(report.roll_rad, 0, 1e-4);
  EXPECT_EQ(report.speed_mps, 0);
  // The weight compresses the wheels: 3840 kg x g / 12 wheels / 1e5 N/m = 5.2 mm.
  EXPECT_NEAR(report.p_S_m.z(), -3840 * test::moon_g_mps2 / 12 / 1e5, 5e-4);
}

// The ground falls to the north, oblique to the heading, so the rover pitches and rolls at once.
TEST(Vehicle, keeps_the_heading_that_was_asked_on_a_slope) {
  const auto ground = test::moon(radians(15), 0);
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  for (const double heading_deg : {60.0, 120.0, 240.0, 300.0}) {
    ASSERT_EQ(vehicle.place(test::start_place, radians(heading_deg)), "");
    const VehicleReport report = vehicle.report();
    EXPECT_NEAR(report.heading_rad, radians(heading_deg), radians(0.2));
    EXPECT_GT(std::abs(report.pitch_rad * report.roll_rad), radians(1));
  }
}

TEST(Vehicle, drives_straight_at_the_speed_it_was_told) {
  const auto ground = test::moon();
  const VehicleConfig config = test::rover(test::moon_g_mps2);
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, radians(90)), "");
  vehicle.command({1.5, 0, false});
  run(vehicle, 20);
  const VehicleReport report = vehicle.report();
  // The rims turn at 1.5 m/s, and slip is counted by the rolling radius.
  const Wheel& wheel = *config.links[2].wheel;
  const double rolling_radius_m = WheelSoil(test::soil(), wheel, test::moon_g_mps2)
                                      .rolling_radius_m(config.mass_kg() * test::moon_g_mps2 / 12);
  EXPECT_NEAR(report.speed_mps, 1.5 * rolling_radius_m / wheel.radius_m * (1 - report.slip), 0.01);
  EXPECT_NEAR(report.p_S_m.y(), 0, 0.01);
  EXPECT_NEAR(report.p_S_m.x(), vehicle.distance_m(), 0.01);
  EXPECT_GT(report.slip, 0);
  EXPECT_LT(report.slip, 0.05);
}

TEST(Vehicle, steady_drive_power_is_the_rolling_resistance) {
  const auto ground = test::moon();
  const VehicleConfig config = test::rover(test::moon_g_mps2);
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  vehicle.command({1, 0, false});
  run(vehicle, 20);
  // Second method: resistance of twelve equally loaded wheels from the pressure law.
  const Wheel& wheel = *config.links[2].wheel;
  const PressureSinkage law(test::soil(), wheel.radius_m, wheel.width_m, test::moon_g_mps2);
  const double load_n = config.mass_kg() * test::moon_g_mps2 / 12;
  const double resistance_n = 12 * law.compaction_resistance_n(vehicle.report().sinkage_m, load_n);
  EXPECT_NEAR(vehicle.report().sinkage_m, law.static_sinkage_m(load_n), 0.0025);  // slip adds to it
  // Rims turn at the 1 m/s commanded; the ground passes slower by the slip.
  const double expected_w = resistance_n * 1.0 / 0.8;
  EXPECT_NEAR(vehicle.drive_w(), expected_w, 0.03 * expected_w);
}

TEST(Vehicle, climbing_takes_the_work_of_climbing) {
  const auto flat = test::moon();
  const auto hill = test::moon(radians(8), radians(180));  // rises to the north
  double energy_jpm[2], slip = 0, rise = 0;
  int i = 0;
  for (const Ground* ground : {flat.get(), hill.get()}) {
    Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
    ASSERT_EQ(vehicle.place(test::start_place, 0), "");
    vehicle.command({1, 0, false});
    run(vehicle, 20);
    const double before_j = vehicle.drive_j(), before_m = vehicle.distance_m();
    const double z_m = vehicle.report().p_S_m.z();
    run(vehicle, 60);
    const double driven_m = vehicle.distance_m() - before_m;
    energy_jpm[i++] = (vehicle.drive_j() - before_j) / driven_m;
    rise = (vehicle.report().p_S_m.z() - z_m) / driven_m;
    slip = vehicle.report().slip;
  }
  EXPECT_NEAR(rise, std::sin(radians(8)), 1e-3);
  // Rims travel 1/(1 - slip) times as far as the rover; resistance falls a little with the load's
  // cosine.
  const double climb_jpm = 3840 * test::moon_g_mps2 * rise / 0.8 / (1 - slip);
  EXPECT_NEAR(energy_jpm[1] - energy_jpm[0] / (1 - slip), climb_jpm, 0.04 * climb_jpm);
}

TEST(Vehicle, holds_on_a_slope_with_its_brakes) {
  const auto ground = test::moon(radians(20), radians(90));
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, radians(90)), "");
  run(vehicle, 20);
  const Vec3 before_S_m = vehicle.report().p_S_m;
  run(vehicle, 300);
  EXPECT_LT((vehicle.report().p_S_m - before_S_m).norm(), 1e-6);
  EXPECT_NEAR(vehicle.report().slope_rad, radians(20), 1e-3);
  EXPECT_NEAR(vehicle.report().pitch_rad, radians(-20), 0.02);
}

// Ground of more curvature than a wheel, where the wheel's lowest point would jump in each step.
TEST(Vehicle, comes_to_rest_among_small_craters) {
  TerrainSpec spec;
  spec.name = "Craters";
  spec.layers = {PlaneSurface{0, 0.05, 0}};
  CraterPopulation craters;
  craters.diameter_min_m = 0.5;
  craters.age_gyr = 3.9;
  spec.detail = Detail{};
  spec.detail->craters = craters;
  spec.soil = test::soil();
  // Six of 600 places at which the test rover was once refused because it never stopped trembling.
  constexpr std::pair<int, int> places[] = {{2, 9}, {2, 12}, {8, 8}, {11, 1}, {14, 1}, {26, 14}};
  for (const auto& [seed, east] : places) {
    const Ground ground(spec, SiteFrame(*find_body("Moon"), {0.1, 0.2, 0}), seed);
    Vehicle vehicle(test::rover(test::moon_g_mps2), ground);
    EXPECT_EQ(vehicle.place({0.1 + 5e-6 * east, 0.2, 0}, 0.2 * seed), "") << seed;
  }
}

TEST(Vehicle, turns_on_the_spot) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  vehicle.command({0, 0.1, false});
  for (int i = 0; i < 200; ++i) {
    vehicle.advance(exchange_period);
    vehicle.command({0, 0.1, false});
  }
  const VehicleReport report = vehicle.report();
  EXPECT_LT(report.p_S_m.head<2>().norm(), 0.2);
  // A left turn, so the heading falls from north; the wheels need seconds to steer into place
  // first.
  EXPECT_GT(report.heading_rad, 2 * std::numbers::pi - 0.1 * 20);
  EXPECT_LT(report.heading_rad, 2 * std::numbers::pi - 0.1 * 12);
}

TEST(Vehicle, half_the_step_ends_at_the_same_place) {
  const auto ground = test::moon(radians(5), radians(200));
  VehicleReport ends[2];
  double energy_j[2];
  for (const int i : {0, 1}) {
    VehicleConfig config = test::rover(test::moon_g_mps2);
    if (i == 1) config.step /= 2;
    Vehicle vehicle(config, *ground);
    ASSERT_EQ(vehicle.place(test::start_place, 0), "");
    vehicle.command({1.5, 0.02, false});
    run(vehicle, 60);
    ends[i] = vehicle.report();
    energy_j[i] = vehicle.drive_j();
  }
  EXPECT_LT((ends[0].p_S_m - ends[1].p_S_m).norm(), 0.02);
  EXPECT_NEAR(energy_j[0], energy_j[1], 0.01 * energy_j[0]);
}

TEST(Vehicle, goes_on_bit_for_bit_from_saved_state) {
  const auto ground = test::moon(radians(5), radians(200));
  Vehicle first(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(first.place(test::start_place, 0), "");
  first.command({1.5, 0.05, false});
  run(first, 5);
  Archive saved = Archive::writer();
  first.archive(saved);
  Vehicle second(test::rover(test::moon_g_mps2), *ground);
  Archive reader = Archive::reader(saved.bytes());
  second.archive(reader);
  for (Vehicle* vehicle : {&first, &second}) {
    run(*vehicle, 5);
    vehicle->command({});
    run(*vehicle, 5);
  }
  Archive a = Archive::writer(), b = Archive::writer();
  first.archive(a);
  second.archive(b);
  EXPECT_EQ(a.bytes(), b.bytes());
}

TEST(Vehicle, crabs_without_turning) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  vehicle.command({0.5, 0, false, 0.5});
  for (int i = 0; i < 300; ++i) {
    vehicle.command({0.5, 0, false, 0.5});
    vehicle.advance(exchange_period);
  }
  const VehicleReport report = vehicle.report();
  // Heading north: ahead is y, left is -x.
  EXPECT_NEAR(report.v_S_mps.y(), -report.v_S_mps.x(), 0.02);
  EXPECT_GT(report.p_S_m.y(), 10);
  EXPECT_NEAR(report.yaw_rad, std::numbers::pi / 2, 0.02);
}

TEST(Vehicle, a_locked_wheel_drags_and_costs_power_and_a_free_one_rolls_along) {
  const auto ground = test::moon();
  double speed_mps[3], power_w[3];
  for (const WheelMode mode : {WheelMode::driven, WheelMode::free, WheelMode::locked}) {
    VehicleConfig config = test::rover(test::moon_g_mps2);
    for (LinkConfig& link : config.links) {
      if (link.name.starts_with("front_left_wheel")) link.wheel_mode = mode;
    }
    Vehicle vehicle(config, *ground);
    ASSERT_EQ(vehicle.place(test::start_place, 0), "");
    vehicle.command({1, 0, false});
    run(vehicle, 20);
    const auto i = static_cast<std::size_t>(mode);
    speed_mps[i] = vehicle.report().speed_mps;
    power_w[i] = vehicle.drive_w();
    for (std::size_t k = 0; k < config.links.size(); ++k) {
      if (config.links[k].wheel_mode == WheelMode::driven) continue;
      const double turned_rad = vehicle.joint_positions()[k];
      if (mode == WheelMode::free) {
        EXPECT_GT(turned_rad, 30);
      } else {
        EXPECT_LT(std::abs(turned_rad), 0.1);
      }
    }
  }
  EXPECT_NEAR(power_w[1], power_w[0], 0.1 * power_w[0]);
  EXPECT_GT(power_w[2], 1.5 * power_w[0]);
  EXPECT_LT(speed_mps[2], speed_mps[0]);
}

TEST(Vehicle, a_motor_gives_no_more_than_its_line_from_stall_to_no_load) {
  const auto ground = test::moon();
  VehicleConfig config = test::rover(test::moon_g_mps2);
  for (LinkConfig& link : config.links) {
    if (link.drive) link.drive->no_load_speed_radps = 3;  // 1.5 m/s at the rim
  }
  Vehicle vehicle(config, *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  vehicle.command({2.5, 0, false});
  run(vehicle, 60);
  // Rolling resistance keeps it a little under the no-load speed.
  EXPECT_LT(vehicle.report().speed_mps, 1.5);
  EXPECT_GT(vehicle.report().speed_mps, 1.2);
}

TEST(Vehicle, starts_on_a_slope_without_rolling_back_and_without_running_away) {
  // The motors take over the torque of the brakes, which is too much uphill and too little
  // downhill.
  for (const double heading : {0.0, 180.0}) {
    const auto ground = test::moon(radians(15), radians(180));
    Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
    ASSERT_EQ(vehicle.place(test::start_place, radians(heading)), "");
    const double begin_m = vehicle.report().p_S_m.y();
    double lowest_m = 0;
    for (int i = 0; i < 200; ++i) {
      vehicle.command({0.5, 0, false});
      vehicle.advance(exchange_period);
      lowest_m = std::min(lowest_m, vehicle.report().p_S_m.y() - begin_m);
    }
    const double spun_mps = 0.5 * vehicle.joint_positions()[2] / 20;
    if (heading == 0) {
      EXPECT_GT(lowest_m, -0.005);
    }
    EXPECT_NEAR(spun_mps, 0.5, 0.05) << heading;
  }
}

TEST(Vehicle, drive_calibration_scales_the_electrical_energy_alone) {
  const auto ground = test::moon();
  double drive_j[2], motors_j[2];
  for (const int i : {0, 1}) {
    VehicleConfig config = test::rover(test::moon_g_mps2);
    if (i == 1) config.drive_calibration = 1.25;
    Vehicle vehicle(config, *ground);
    ASSERT_EQ(vehicle.place(test::start_place, 0), "");
    vehicle.command({1, 0, false});
    run(vehicle, 20);
    drive_j[i] = vehicle.drive_j();
    motors_j[i] = vehicle.work().motors_j;
  }
  EXPECT_NEAR(drive_j[1], 1.25 * drive_j[0], 1e-9 * drive_j[0]);
  EXPECT_EQ(motors_j[1], motors_j[0]);
}

TEST(Vehicle, electrical_energy_is_the_motors_work_over_their_efficiency_on_the_level) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  vehicle.command({1, 0, false});
  run(vehicle, 30);
  EXPECT_NEAR(vehicle.drive_j(), vehicle.work().motors_j / 0.8, 0.005 * vehicle.drive_j());
}

TEST(Vehicle, lies_on_its_chassis_when_wheels_find_no_hold) {
  // Soft springs let the chassis down to the ground.
  const auto ground = test::moon();
  VehicleConfig config = test::rover(test::moon_g_mps2);
  config.chassis_clearance_m = 0.05;
  for (LinkConfig& link : config.links) {
    if (!link.spring) continue;
    link.spring->preload *= 0.2;
    link.spring->stiffness = 1000;
    link.spring->stop_stiffness = 1000;
  }
  Vehicle vehicle(config, *ground);
  vehicle.place(test::start_place, 0);
  run(vehicle, 5);
  const VehicleReport report = vehicle.report();
  EXPECT_TRUE(report.is_chassis_on_ground);
  // The chassis does not sink through: its underside stays near the ground.
  EXPECT_NEAR(report.p_S_m.z() + 0.05, 0, 0.06);
}

TEST(Vehicle, says_where_numbers_broke_and_stops) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  run(vehicle, 1);
  vehicle.command({std::nan(""), 0, false});
  run(vehicle, 1);
  EXPECT_FALSE(vehicle.report().is_finite);
  EXPECT_NE(vehicle.fault().find("not finite in step 201"), std::string::npos) << vehicle.fault();
  EXPECT_NE(vehicle.fault().find("front_left_wheel_1 had"), std::string::npos) << vehicle.fault();
}

TEST(Vehicle, its_energy_changes_by_the_work_done_on_it) {
  const auto ground = test::moon();
  Vehicle vehicle(test::rover(test::moon_g_mps2), *ground);
  ASSERT_EQ(vehicle.place(test::start_place, 0), "");
  vehicle.command({2, 0, false});
  run(vehicle, 5);
  const WorkDone before = vehicle.work();
  const double before_j = vehicle.kinetic_j() + vehicle.potential_j();
  run(vehicle, 5);
  const WorkDone after = vehicle.work();
  const double change_j = vehicle.kinetic_j() + vehicle.potential_j() - before_j;
  EXPECT_NEAR(after.sum_j() - before.sum_j(), change_j, 0.01 * after.motors_j);
}

TEST(StabilityFaults, refuse_a_step_too_long_for_a_stiff_wheel) {
  VehicleConfig config = test::rover(test::moon_g_mps2);
  EXPECT_TRUE(stability_faults(config).empty());
  // A wheel like MER's, 1.5 kg on 1e5 N/m, is unstable at 5 ms (omega x step = 1.29).
  config.links[2].inertia.mass_kg = 1.5;
  const std::vector<std::string> faults = stability_faults(config);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].find("omega x step is 1.29"), std::string::npos) << faults[0];
}

}  // namespace
}  // namespace lsos
