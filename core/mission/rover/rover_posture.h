// Changes of the stance of a rover on limbs.
#pragma once

#include "mission/port/rover_port.h"
#include "vehicle/vehicle.h"

namespace lsos {

// How long a change of stance takes, and the least that it may take at the joints' greatest rates.
struct PostureTime {
  double takes_s = 0, least_s = 0;
};
// See RoverPort::set_posture().
PostureTime set_posture(Vehicle& vehicle, const PostureRequest& request);

// What a change of stance is expected to take with the time in which the limbs settle, and the
// electrical energy of their motors: of their controllers, and of raising the chassis and half of
// the limbs by `rise_m`.
struct PostureWork {
  double takes_s = 0, energy_j = 0;
};
PostureWork expected_work(const Vehicle& vehicle, const PostureTime& time, double rise_m,
                          double gravity_mps2);

// Height of the chassis' underside over the ground, mean over the wheels as the limbs hold them;
// NaN: not on limbs.
double posture_clearance_m(const Vehicle& vehicle);

}  // namespace lsos
