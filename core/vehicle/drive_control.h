// From the motion that is wanted of the vehicle to angles of its steering joints and speeds of its
// wheels: every wheel that can steer rolls about one common centre of turning (double Ackermann,
// crab and point turn are the same rule); those that cannot slide sideways as little as may be.
#pragma once

#include <vector>

#include "base/archive.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Wanted motion of the reference point.
struct DriveCommand {
  double speed_mps = 0;       // along the heading, backwards negative
  double yaw_rate_radps = 0;  // to the left positive
  bool is_braking = true;     // brakes on; the rest is then ignored
  double left_mps = 0;        // sideways: vehicles that can crab

  void archive(Archive& a) { a(speed_mps)(yaw_rate_radps)(is_braking)(left_mps); }
};

// Where steering joints and wheels stand, from the configuration's tree.
struct WheelLayout {
  struct Steering {
    int link = 0;
    Vec2 p_B_m;  // of its axis
    double angle_max_rad = 0;
  };
  struct WheelPlace {
    int link = 0;
    int steering = -1;    // index into `steerings`, -1: fixed straight ahead
    double offset_m = 0;  // along the axle from the steering axis, left positive
    Vec2 p_B_m;           // with the steering straight ahead
    double radius_m = 0;
    WheelMode mode = WheelMode::driven;
  };
  std::vector<Steering> steerings;
  std::vector<WheelPlace> wheels;
  double turning_x_B_m = 0;  // where wheels that cannot steer stand, on the mean: the vehicle
                             // turns about a point beside it
  double skid_track_ratio = 1;
};
WheelLayout wheel_layout(const VehicleConfig& config);

struct WheelTargets {
  std::vector<double> steering_angle_rad;  // by steering
  std::vector<double> spin_radps;          // by wheel
};

// `steering_now_rad`: present angles. Of the two directions a wheel can point in, the nearer one
// is taken. Standing still keeps the angles. Spins fade to zero while steerings are far (over
// 0.2 rad, fully at 0.8) from their target, so that wheels do not fight each other.
WheelTargets wheel_targets(const WheelLayout& layout, const DriveCommand& command,
                           const std::vector<double>& steering_now_rad);

}  // namespace lsos
