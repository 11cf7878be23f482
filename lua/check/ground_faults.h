// Faults of a plan's ground and routes where the plan has others that do not touch them.
#pragma once

#include <vector>

#include "base/error.h"
#include "mission/simulation.h"

namespace lsos {

// Waits that go in a circle change nothing of where rovers stand and drive: the mission is prepared
// without its waits, and what is wrong then is told in one go. None where `known` has other errors,
// which may be to blame. `setup`: of that mission.
std::vector<Fault> ground_faults(const Faults& known, SimulationSetup setup);

}  // namespace lsos
