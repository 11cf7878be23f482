// The pose that a path follower takes of a vehicle.
#pragma once

#include <cmath>

#include "vehicle/path_follower.h"
#include "vehicle/vehicle.h"

namespace lsos {

inline FollowerPose follower_pose(const VehicleReport& report) {
  const Vec2 left_S(-std::sin(report.yaw_rad), std::cos(report.yaw_rad));
  return {report.p_S_m.head<2>(),   report.yaw_rad,
          report.speed_mps,         left_S.dot(report.v_S_mps.head<2>()),
          report.incline_pitch_rad, report.incline_roll_rad};
}

}  // namespace lsos
