// Check before a mission runs: whether the known ground around its stops reaches far enough for
// what they see of the Sun and of Earth.
#pragma once

#include <vector>

#include "mission/model/machine.h"
#include "terrain/ground.h"

namespace lsos {

// Estimated duration of the plan's events: that of the rover that takes longest, from the durations
// and times in the plan and its drives at the requested speeds, else at 1 m/s; at most MaxDuration.
SimTime estimated_duration(const MissionMachine& machine, const SiteFrame& site);

// At most one warning for the Sun and one for Earth, each for the stop and time at which ground
// farthest away matters. `watches_sun`: something in the mission uses sunlight.
std::vector<Fault> ground_end_warnings(const MissionMachine& machine, const Ground& ground,
                                       bool watches_sun);

}  // namespace lsos
