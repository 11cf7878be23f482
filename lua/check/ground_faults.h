// Faults of a plan's ground and routes where the plan has others already.
#pragma once

#include <vector>

#include "base/error.h"
#include "lua/host/mission_files.h"
#include "mission/simulation.h"

namespace lsos {

// The mission is prepared as far as its faults leave known where rovers stand and drive, and what
// is wrong then is told in one go with them. None where faults leave nothing known, such as one of
// the mission's ground or of a rover's script. `setup`: of that mission.
std::vector<Fault> ground_faults(const MissionFiles& files, SimulationSetup setup);

}  // namespace lsos
