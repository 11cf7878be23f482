// Inverse kinematics of driving: steering angles and wheel speeds for a wanted motion of the
// vehicle. All wheels that steer roll about one common centre of turning (double Ackermann, crab
// and point turn are the same rule); wheels that cannot steer slide sideways as little as possible.
#pragma once

#include <vector>

#include "base/archive.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Wanted motion of the reference point.
struct DriveCommand {
  double speed_mps = 0;       // along the heading, backwards negative
  double yaw_rate_radps = 0;  // left positive
  bool is_braking = true;     // brakes on; the other members are then ignored
  double left_mps = 0;        // sideways, for vehicles that can crab

  void archive(Archive& a) { LSOS_ARCHIVE(a, speed_mps, yaw_rate_radps, is_braking, left_mps); }
};

// Positions and headings of steering joints and wheels, from the configuration's tree of links,
// with its limbs' joints as they are initially.
struct WheelLayout {
  struct Steering {
    int link = 0;
    Vec2 p_B_m;  // steering axis
    double angle_max_rad = 0;
    double heading_rad = 0;  // of its wheels where it is at 0, left positive
  };
  struct WheelPlace {
    int link = 0;
    int steering = -1;    // index into `steerings`, -1: fixed
    double offset_m = 0;  // along the axle from the steering axis, left positive
    Vec2 p_B_m;           // with the steering at 0
    double radius_m = 0;
    WheelMode mode = WheelMode::driven;
    double heading_rad = 0;  // with the steering at 0
  };
  std::vector<Steering> steerings;
  std::vector<WheelPlace> wheels;
  double turning_x_B_m = 0;  // x of the centre of turning: mean over the wheels that cannot steer
  double skid_track_ratio = 1;
};
WheelLayout wheel_layout(const VehicleConfig& vehicle);

struct WheelTargets {
  std::vector<double> steering_angle_rad;  // by steering
  std::vector<double> spin_radps;          // by wheel
};

// `steering_now_rad`: present angles. A wheel turns to the nearer one of its two possible
// directions. A command without motion keeps the angles. Wheel speeds fade to zero while a steering
// angle is off its target (from 0.2 rad, fully at 0.8 rad), to keep wheels from working against
// each other. `are_stuck`, by steering (empty: none is): keep their angle; their wheels roll as
// fast as the motion goes along it, and the others do not wait for them.
WheelTargets wheel_targets(const WheelLayout& layout, const DriveCommand& command,
                           const std::vector<double>& steering_now_rad,
                           const std::vector<bool>& are_stuck = {});

}  // namespace lsos
