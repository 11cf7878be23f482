// Electrical power of a wheel's drive: the work at the wheel, and what motor, gears and controller
// lose.
#pragma once

#include <algorithm>
#include <cmath>

#include "vehicle/vehicle_config.h"

namespace lsos {

// With torque T and spin w at the wheel, after gearing:
//  driving (T w > 0):  P = T w / eta + k T^2 + T_f |w| + P_0,
//  braking (T w < 0):  P = max(P_0, eta T w + k T^2 + T_f |w| + P_0).
// eta: gears, in proportion to what they carry; k T^2: current in the windings, k = R / (i k_t)^2
// for windings of R ohm, a torque constant k_t in N m/A and a gear ratio i; T_f: bearings, seals
// and gears that turn without a load; P_0: the controller while the brake is open. A motor that
// brakes works as a generator, whose output covers the drive's own losses; nothing is fed back to
// the battery.
inline double drive_power_w(const DriveMotor& motor, double torque_n_m, double spin_radps) {
  const double work_w = torque_n_m * spin_radps;
  const double through_gears_w = work_w > 0 ? work_w / motor.efficiency : work_w * motor.efficiency;
  const double lost_w = motor.winding_loss_w_pn2m2 * torque_n_m * torque_n_m +
                        motor.friction_n_m * std::abs(spin_radps);
  return motor.idle_w + std::max(0.0, through_gears_w + lost_w);
}

// The same for a limb's motor while it turns, without friction.
inline double limb_power_w(const LimbMotor& motor, double torque_n_m, double rate_radps) {
  const double work_w = torque_n_m * rate_radps;
  const double through_gears_w = work_w > 0 ? work_w / motor.efficiency : work_w * motor.efficiency;
  const double lost_w = motor.winding_loss_w_pn2m2 * torque_n_m * torque_n_m;
  return motor.idle_w + std::max(0.0, through_gears_w + lost_w);
}

}  // namespace lsos
