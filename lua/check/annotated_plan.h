// `check --kml`: the plan as it was drawn, with what is expected of its events.
#pragma once

#include <string>

#include "lua/host/mission_files.h"
#include "mission/mission_estimate.h"

namespace lsos {

// The file of the plan with the estimate in the balloons and times of its events, with their
// warnings, and as a folder Estimate. Read as a plan it is the same one, and what an earlier call
// added is replaced. `simulation`: that of the estimate, at its end. Throws InputError where the
// plan is no KML or KMZ of one document.
std::string annotated_plan(const MissionFiles& files, const Simulation& simulation,
                           const MissionEstimate& estimate);

}  // namespace lsos
