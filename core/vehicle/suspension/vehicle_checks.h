// Checks for what makes a vehicle unfit for simulation. One sentence each; empty if all is well.
#pragma once

#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// Springs, dampers and servos that are too stiff for the step. Explicit integration is stable for
// omega dt < 2 with a mode of angular frequency omega, and for dt < 2 T with a damper that halts
// its inertia in a time T; omega dt > 1 or dt > T is refused. Each is checked alone, with the
// inertia that it moves; a wheel's normal spring with the mass of the wheel alone, since its
// carrier may give way. On limbs, whose joints follow one another, also the stiffest mode of the
// whole.
std::vector<std::string> stability_faults(const VehicleConfig& vehicle);

// Faults at rest on level ground with all joints at 0: wheels must be on the ground and clear of
// each other, the chassis above the ground.
std::vector<std::string> rest_faults(const VehicleConfig& vehicle,
                                     double height_tolerance_m = 1e-6);
// Joints of limbs that are below the ground, in the same state.
std::vector<std::string> buried_joint_faults(const VehicleConfig& vehicle);
// The centre of mass must be over the wheels, in the same state.
std::vector<std::string> balance_faults(const VehicleConfig& vehicle);

// Whether the centre of mass is over the wheels, in the same state, where the vertical is `up_B`.
bool is_balanced(const VehicleConfig& vehicle, const Vec3& up_B);

// Whether the vehicle can do what it declares: turn, crab, and reach its speed with its motors.
std::vector<std::string> ability_faults(const VehicleConfig& vehicle);

// Grousers with inconsistent height and number, or higher than the wheel's radius.
std::vector<std::string> grouser_faults(const Wheel& wheel);

}  // namespace lsos
