// What makes a vehicle unfit to be simulated.
#pragma once

#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// Springs too stiff for the step: explicit integration of a mode of angular frequency omega is
// stable for omega dt < 2; more than 1 is refused. One sentence each, empty when all is well.
std::vector<std::string> stability_faults(const VehicleConfig& vehicle);

}  // namespace lsos
