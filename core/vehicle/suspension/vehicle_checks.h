// What makes a vehicle unfit to be simulated. One sentence each, empty when all is well.
#pragma once

#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// Springs and dampers too stiff for the step: explicit integration of a mode of angular frequency
// omega is stable for omega dt < 2, of a damper that halts its inertia in a time T for dt < 2 T;
// more than 1 of either is refused. Each is looked at alone, with the inertia that it moves; a
// wheel's normal spring with the wheel's mass alone, as its carrier may give way.
std::vector<std::string> stability_faults(const VehicleConfig& vehicle);

// How it stands at rest on level ground with all joints at 0: wheels on the ground and clear of
// each other, chassis above the ground.
std::vector<std::string> rest_faults(const VehicleConfig& vehicle);
// The same: centre of mass over the wheels.
std::vector<std::string> balance_faults(const VehicleConfig& vehicle);

// Whether the vehicle can move as it says it can: turning, crabbing, speed of its motors.
std::vector<std::string> ability_faults(const VehicleConfig& vehicle);

// Grousers that are no grousers.
std::vector<std::string> grouser_faults(const Wheel& wheel);

}  // namespace lsos
