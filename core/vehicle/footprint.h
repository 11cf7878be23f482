// The ground that a vehicle covers.
#pragma once

#include "base/footprint.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Rectangle around chassis and wheels, with the reference point at the origin, heading along x,
// wheels straight ahead, on limbs in the stance in which it starts.
Footprint footprint_at_rest(const VehicleConfig& config);

}  // namespace lsos
