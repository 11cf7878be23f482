// Limits within which a rover follows a line, from what its vehicle can do.
#pragma once

#include "vehicle/path_follower.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// `speed_mps`: requested speed, of which at most the vehicle's greatest counts.
FollowerLimits limits_of(const VehicleConfig& vehicle, double speed_mps, double gravity_mps2);

}  // namespace lsos
