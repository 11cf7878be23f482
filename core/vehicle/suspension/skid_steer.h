// Suspension template: wheels that do not steer, either on the chassis or on a rocker on each side.
// The vehicle turns by driving its sides at different speeds while its wheels slide sideways.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/suspension/rocker_bogie.h"

namespace lsos {

struct SkidSteer {
  std::vector<WheelStation> stations;        // none may be steered or on a bogie
  std::optional<SwingArm> rocker;            // absent: wheels on the chassis
  std::optional<Differential> differential;  // ties the rockers
  double wheel_mass_kg = 0;
  std::optional<Vec3> wheel_moments_kgm2;  // forward, axle, up; default: those of a disc
  Wheel wheel;
  DriveMotor drive;
  double turning_track_ratio = 1;  // >= 1; see VehicleConfig::skid_track_ratio
};

// Adds the links to `vehicle`, named as in rocker_bogie.h.
void add_skid_steer(VehicleConfig& vehicle, const SkidSteer& suspension);

// Inconsistencies, one sentence each; empty if there are none.
std::vector<std::string> skid_steer_faults(const SkidSteer& suspension);

}  // namespace lsos
