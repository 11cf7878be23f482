// Estimates when the events of a plan begin, before it runs.
#pragma once

#include <map>
#include <string>

#include "mission/model/machine.h"
#include "mission/model/rover_model.h"

namespace lsos {

// When each event is expected to begin, since the mission's start: behind the events before it on
// its rover and those in its StartAfter, and not before its StartTime. `rovers`: by
// PlanRover::model(). Waits for a condition or charge are not foreseen.
std::map<PlanEvent::Reference, SimTime> expected_begins(
    const MissionMachine& machine, const std::map<std::string, RoverModel>& rovers);

}  // namespace lsos
