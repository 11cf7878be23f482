// Suspension template: wheels on limbs, which are chains of revolute joints with motors (ATHLETE).
// A limb may end in a knuckle that steers its wheel.
//
// Links are named limb_1_hip_pitch after limb and joint, limb_1_steering, limb_1_wheel. Joints are
// at 0 in the stance in which the script describes the limbs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// A joint of a limb, with the segment that it moves.
struct LimbJoint {
  std::string name;             // "hip_pitch"
  Vec3 p_B_m = Vec3::Zero();    // at rest
  Vec3 axis_B = Vec3::UnitZ();  // unit, at rest
  LimbActuator actuator;
  double mass_kg = 0;  // of the segment to the next joint
  // Centre of mass at rest; default: the middle between this joint and the next.
  std::optional<Vec3> p_B_center_m = std::nullopt;
  // Moments about the centre of mass, along the chassis' axes at rest; default: those of a rod
  // between the joints, whose products of inertia are neglected, plus those of a ball of 5 cm.
  std::optional<Vec3> moments_kgm2 = std::nullopt;
};

struct Limb {
  std::string name;                 // "limb_1"
  Vec2 p_B_wheel_m = Vec2::Zero();  // the wheel's place on the ground at rest
  std::vector<LimbJoint> joints;    // from the chassis outwards
  bool is_steered = true;           // its wheel turns about the vertical on a knuckle
};

struct Legged {
  std::vector<Limb> limbs;
  std::optional<PostureGains> posture;
  double knuckle_mass_kg = 0;  // one knuckle: the steered mass without the wheel
  SteeringMotor steering;
  double wheel_mass_kg = 0;
  std::optional<Vec3> wheel_moments_kgm2;  // forward, axle, up; default: those of a disc
  Wheel wheel;
  DriveMotor drive;
};

// Adds the links and limbs to `vehicle`.
void add_legged(VehicleConfig& vehicle, const Legged& suspension);

// Inconsistencies, one sentence each; empty if there are none.
std::vector<std::string> legged_faults(const Legged& suspension);

}  // namespace lsos
