// Changes of the stance of a rover on limbs.
#pragma once

#include "mission/port/rover_port.h"
#include "vehicle/vehicle.h"

namespace lsos {

// See RoverPort::set_posture().
double set_posture(Vehicle& vehicle, const PostureRequest& request);

// Height of the chassis' underside over the ground, mean over the wheels as the limbs hold them;
// NaN: not on limbs.
double posture_clearance_m(const Vehicle& vehicle);

}  // namespace lsos
