// Suspension template: wheels that are not steered, straight on the chassis or on a rocker on each
// side. It turns by driving its sides at different speeds, with its wheels sliding sideways.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/suspension/rocker_bogie.h"

namespace lsos {

struct SkidSteer {
  std::vector<WheelStation> stations;        // none is steered or on a bogie
  std::optional<SwingArm> rocker;            // without: rigid
  std::optional<Differential> differential;  // ties the rockers
  double wheel_mass_kg = 0;
  std::optional<Vec3> wheel_moments_kgm2;  // forward, axle, up; by default of a disc
  Wheel wheel;
  DriveMotor drive;
  double turning_track_ratio = 1;  // >= 1; see VehicleConfig::skid_track_ratio
};

// Adds the links to `vehicle`, named as by rocker_bogie.h.
void add_skid_steer(VehicleConfig& vehicle, const SkidSteer& suspension);

// What does not fit together, one sentence each; empty when fine.
std::vector<std::string> skid_steer_faults(const SkidSteer& suspension);

}  // namespace lsos
