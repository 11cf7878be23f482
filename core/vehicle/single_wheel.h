// A single-wheel test bed: one wheel held at a load, slip and slip angle until its state is steady.
// It uses the same wheel_soil.h as the vehicles. Slip is counted by the rolling radius
// (wheel_soil.h), and here refers to the speed of travel, as rigs report it; the log's slip refers
// to the speed along the heading and differs at slip angles.
#pragma once

#include "vehicle/wheel_soil.h"

namespace lsos {

struct SingleWheelPoint {
  double slip = 0;            // -1..1: 1 - v/(r w) driving, r w/v - 1 braking; v: travel speed
  double slip_angle_rad = 0;  // direction of travel from the heading, left positive
  double drawbar_pull_n = 0;  // along the heading
  double side_force_n = 0;    // on the wheel, left positive
  double torque_n_m = 0;      // about the axle, driving positive
  double sinkage_m = 0;
  double traction_limit_n = 0;  // the soil's shear strength at that sinkage
};

// Share of the load above which a pull is not to be believed: no measured wheel has reached it.
inline constexpr double pull_share_max = 0.8;

// Slip by one radius of a wheel whose slip by another is given: rigs count it by the rim or by the
// tips of the grousers. Both -1..1.
double slip_by(double radius_m, double slip, double slip_radius_m);

// `slip` -1..1, `slip_angle_rad` -pi/2..pi/2.
SingleWheelPoint single_wheel(const WheelSoil& wheel_soil, double load_n, double slip,
                              double slip_angle_rad);

}  // namespace lsos
