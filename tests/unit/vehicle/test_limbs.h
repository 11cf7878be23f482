// A vehicle on six limbs with round numbers, three joints each and a steered wheel.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "unit/vehicle/test_rover.h"
#include "vehicle/suspension/rover_spec.h"

namespace lsos::test {

inline constexpr double hip_r_m = 1, hip_z_m = 1, thigh_m = 1, shin_m = 1.2, wheel_r_m = 2;

// A limb that reaches out at `azimuth_rad` from ahead, its knee straight over the line from hip to
// hub: two links in a vertical plane, a yaw joint before them.
inline Limb limb(const std::string& name, double azimuth_rad) {
  const Vec3 out(std::cos(azimuth_rad), std::sin(azimuth_rad), 0);
  const Vec3 aside(-out.y(), out.x(), 0);
  const auto place = [&](double r_m, double z_m) { return Vec3(r_m * out + z_m * Vec3::UnitZ()); };
  const Vec3 hip = place(hip_r_m, hip_z_m), hub = place(wheel_r_m, 0.5);
  // Law of cosines: the knee from the distance between hip and hub.
  const double reach_m = (hub - hip).norm();
  const double along_m = (reach_m * reach_m + thigh_m * thigh_m - shin_m * shin_m) / (2 * reach_m);
  const double above_m = std::sqrt(thigh_m * thigh_m - along_m * along_m);
  const Vec3 line = (hub - hip) / reach_m, across = line.cross(-aside);
  const Vec3 knee = hip + along_m * line + above_m * (across.z() > 0 ? across : Vec3(-across));
  const LimbMotor motor{.rate_max_radps = 0.2,
                        .torque_max_n_m = 2000,
                        .stiffness_n_m_prad = 3e4,
                        .damping_n_m_sprad = 800,
                        .brake_torque_max_n_m = 3000,
                        .efficiency = 0.5,
                        .winding_loss_w_pn2m2 = 1e-5,
                        .idle_w = 1};
  Limb limb;
  limb.name = name;
  limb.p_B_wheel_m = hub.head<2>();
  limb.joints = {
      {.name = "yaw",
       .p_B_m = hip,
       .axis_B = Vec3::UnitZ(),
       .actuator = {motor, -1, 1},
       .mass_kg = 10},
      {.name = "hip", .p_B_m = hip, .axis_B = aside, .actuator = {motor, -1.5, 1.5}, .mass_kg = 20},
      {.name = "knee",
       .p_B_m = knee,
       .axis_B = aside,
       .actuator = {motor, -1.5, 1.5},
       .mass_kg = 15}};
  return limb;
}

inline Legged limbs() {
  Legged legged;
  for (int i = 0; i < 6; ++i) {
    legged.limbs.push_back(
        limb("limb_" + std::to_string(i + 1), (2 * i + 1) * std::numbers::pi / 6));
  }
  legged.posture = PostureGains{2, 5e-4};
  legged.knuckle_mass_kg = 10;
  legged.steering = {.angle_max_rad = 3.2,
                     .rate_max_radps = 0.6,
                     .torque_max_n_m = 400,
                     .stiffness_n_m_prad = 8000,
                     .damping_n_m_sprad = 150};
  legged.wheel_mass_kg = 20;
  legged.wheel = {.radius_m = 0.5,
                  .width_m = 0.3,
                  .normal_stiffness_npm = 3e4,
                  .normal_damping_nspm = 500,
                  .tangential_damping_nspm = 300};
  legged.drive = {.torque_max_n_m = 300,
                  .power_max_w = 300,
                  .efficiency = 0.8,
                  .servo_gain_n_m_sprad = 100,
                  .servo_integral_n_m_prad = 100,
                  .brake_torque_max_n_m = 500,
                  .brake_stiffness_n_m_prad = 5e3,
                  .brake_damping_n_m_sprad = 60};
  return legged;
}

inline RoverSpec rover_on_limbs() {
  RoverSpec spec;
  spec.name = "Test";
  VehicleConfig& v = spec.vehicle;
  v.type = "Test";
  v.chassis = {400, {300, 300, 500}};
  v.p_BC_m = {0, 0, 1};
  v.chassis_size_m = {2, 2, 0.4};
  v.chassis_clearance_m = 0.8;
  v.cruise_speed_mps = 0.4;
  v.speed_max_mps = 0.5;
  v.acceleration_mps2 = 0.1;
  v.can_turn_on_spot = v.can_crab = true;
  spec.suspension = limbs();
  return spec;
}

}  // namespace lsos::test
