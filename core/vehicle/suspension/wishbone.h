// Suspension template: independently sprung wheel modules (SEV, LRV). Each module travels
// vertically, may steer about a vertical axis, and carries one or more wheels on one axle line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

struct WishboneModule {
  std::string name;        // "front_left"
  Vec2 p_B_m;              // steering axis: x forward, y left
  bool is_steered = true;  // steered modules have a knuckle and its mass
};

struct Wishbone {
  std::vector<WishboneModule> modules;
  // Unsprung masses of one module: the arms, which are not steered, and the knuckle with its
  // motors.
  double arm_mass_kg = 0;
  double knuckle_mass_kg = 0;
  double stiffness_npm = 0;  // at the wheel
  double damping_nspm = 0;
  double travel_up_m = 0;    // compression from rest to the stop, > 0
  double travel_down_m = 0;  // droop from rest to the stop, > 0
  SteeringMotor steering;
  std::vector<double> wheel_offsets_m;  // along the axle from the steering axis, left positive
  double wheel_mass_kg = 0;
  std::optional<Vec3> wheel_moments_kgm2;  // forward, axle, up; default: those of a disc
  Wheel wheel;
  DriveMotor drive;
};

// Adds the modules' links to `vehicle`: front_left_arm, front_left_steering, front_left_wheel_1.
// The preload of the springs holds the chassis level in `gravity_mps2`. The ride height is
// therefore set at the site, as with an adjustable suspension; this is added to the assumptions.
void add_wishbone(VehicleConfig& vehicle, const Wishbone& wishbone, double gravity_mps2);

// Inconsistencies ("wheel_offsets_m is empty"), one sentence each; empty if there are none.
std::vector<std::string> wishbone_faults(const Wishbone& wishbone);

}  // namespace lsos
