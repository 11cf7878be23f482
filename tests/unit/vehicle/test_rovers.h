// Small rovers with round numbers: on rockers and bogies, and with skid steering.
#pragma once

#include "test_rover.h"
#include "vehicle/suspension/rover_spec.h"

namespace lsos::test {

inline Wheel small_wheel() {
  return {.radius_m = 0.15,
          .width_m = 0.1,
          .normal_stiffness_npm = 2e4,
          .normal_damping_nspm = 300,
          .tangential_damping_nspm = 100};
}

inline DriveMotor small_drive() {
  return {.torque_max_n_m = 30,
          .power_max_w = 50,
          .efficiency = 0.5,
          .servo_gain_n_m_sprad = 2,
          .servo_integral_n_m_prad = 10,
          .brake_torque_max_n_m = 40,
          .brake_stiffness_n_m_prad = 300,
          .brake_damping_n_m_sprad = 2};
}

inline SwingArm arm(const Vec3& pivot_m, double mass_kg) {
  return {.p_B_pivot_m = pivot_m,
          .mass_kg = mass_kg,
          .angle_max_rad = 0.6,
          .stop_stiffness_n_m_prad = 1000,
          .stop_damping_n_m_sprad = 40,
          .damping_n_m_sprad = 3};
}

// Nothing is placed symmetrically, so no loads agree by chance.
inline RockerBogie rocker_bogie() {
  RockerBogie s;
  s.stations = {{"front", {0.7, 0.5}, true, true, Arm::rocker},
                {"middle", {0.1, 0.55}, false, true, Arm::bogie},
                {"rear", {-0.6, 0.5}, true, true, Arm::bogie}};
  s.rocker = arm({0.15, 0.4, 0.4}, 6);
  s.rocker.p_B_center_m = Vec3(0.2, 0.4, 0.4);
  s.bogie = arm({-0.2, 0.45, 0.25}, 4);
  s.bogie->p_B_center_m = Vec3(-0.2, 0.45, 0.25);
  s.differential = {.kind = Differential::Kind::bar,
                    .p_B_m = {-0.1, 0, 0.6},
                    .mass_kg = 5,
                    .stiffness_n_m_prad = 8000,
                    .damping_n_m_sprad = 150};
  s.knuckle_mass_kg = 2;
  s.steering = {.angle_max_rad = 1.2,
                .rate_max_radps = 0.3,
                .torque_max_n_m = 40,
                .stiffness_n_m_prad = 300,
                .damping_n_m_sprad = 3};
  s.wheel_mass_kg = 2;
  s.wheel = small_wheel();
  s.drive = small_drive();
  return s;
}

inline SkidSteer skid_steer() {
  SkidSteer s;
  s.stations = {{"front", {0.4, 0.3}}, {"rear", {-0.4, 0.3}}};
  s.wheel_mass_kg = 2;
  s.wheel = small_wheel();
  s.drive = small_drive();
  s.turning_track_ratio = 1.5;
  return s;
}

// The chassis alone, without links.
inline VehicleConfig small_body() {
  VehicleConfig v;
  v.type = "Small";
  v.chassis = {120, {8, 10, 14}};
  v.p_BC_m = {0.05, 0, 0.5};
  v.chassis_size_m = {0.8, 0.5, 0.4};
  v.chassis_clearance_m = 0.3;
  v.cruise_speed_mps = 0.2;
  v.speed_max_mps = 0.3;
  v.acceleration_mps2 = 0.1;
  v.turning_radius_min_m = 2;
  return v;
}

inline RoverSpec rocker_bogie_rover() {
  return {.name = "Small", .vehicle = small_body(), .suspension = rocker_bogie()};
}

inline RoverSpec skid_steer_rover() {
  RoverSpec spec{.name = "Small", .vehicle = small_body(), .suspension = skid_steer()};
  spec.vehicle.can_turn_on_spot = true;
  return spec;
}

// The six-module rover of test_rover.h.
inline RoverSpec wishbone_rover() {
  RoverSpec spec{.name = "Test", .vehicle = rover(1), .suspension = suspension()};
  spec.vehicle.links.clear();
  spec.vehicle.assumptions.clear();
  return spec;
}

}  // namespace lsos::test
