// Check before a mission runs: whether the known ground around its stops reaches far enough for
// what they see of the Sun and of Earth.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/model/machine.h"
#include "mission/model/rover_model.h"
#include "terrain/ground.h"

namespace lsos {

// At most one warning for the Sun and one for Earth, each for the stop and time at which ground
// farthest away matters. `watches_sun`: something in the mission uses sunlight.
std::vector<Fault> ground_end_warnings(const MissionMachine& machine,
                                       const std::map<std::string, RoverModel>& models,
                                       const Ground& ground, bool watches_sun);

}  // namespace lsos
