// Before a mission runs: whether the ground around its stops reaches as far as counts for what they
// see of the Sun and of Earth.
#pragma once

#include <vector>

#include "mission/model/machine.h"
#include "terrain/ground.h"

namespace lsos {

// How long the plan's events take in all, about: the rover's that takes longest, by the durations
// and times that the plan gives and its drives at the speeds asked for, else at 1 m/s; MaxDuration
// at most.
SimTime rough_duration(const MissionMachine& machine, const SiteFrame& site);

// At most a warning for the Sun and one for Earth, each with the stop and time at which the
// farthest ground counts. `watches_sun`: something in the mission takes its light.
std::vector<Fault> end_ahead(const MissionMachine& machine, const Ground& ground, bool watches_sun);

}  // namespace lsos
