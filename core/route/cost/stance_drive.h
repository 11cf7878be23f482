// Driving on the ground under a rover's wheels: speed and energy where it is inclined both ways and
// rough.
#pragma once

#include "route/cost/drive_cost.h"
#include "route/cost/stance.h"

namespace lsos {

// Values of the table for the slope ahead, changed by the cross slope and by rough ground;
// `energy_jpm` includes the controllers.
SlopeDrive stance_drive(const DriveCost& cost, const Stance& stance);

}  // namespace lsos
