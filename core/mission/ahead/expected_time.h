// Estimates when the events of a plan end, before it runs.
#pragma once

#include "mission/model/machine.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Expected end of an event, counted from the start of the mission, from the durations and times in
// the plan and the drawn length at the speed of the drive. `begins`: when its turn comes. `at`:
// place of the rover, updated to that at the end.
SimTime expected_end(const EventMachine& machine, const VehicleConfig& vehicle, SimTime begins,
                     Instant mission_start, const Body& body, Geodetic& at);

}  // namespace lsos
