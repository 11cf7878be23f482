// The ground that a vehicle covers.
#pragma once

#include "base/footprint.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Round its chassis and wheels, with its reference point at the origin, heading along x, wheels
// straight ahead.
Footprint footprint_at_rest(const VehicleConfig& vehicle);

}  // namespace lsos
