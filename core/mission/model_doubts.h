// Numbers of rovers, assets and soils that can be simulated, and yet are likely to be slips: in
// another unit, or of another thing. One sentence each; empty when all is well.
#pragma once

#include <string>
#include <vector>

#include "mission/rover_model.h"
#include "terrain/soil.h"

namespace lsos {

// Each is judged by the rover's own size, mass, speed and loads.
std::vector<std::string> rover_doubts(const RoverModel& rover);
std::vector<std::string> asset_doubts(const AssetModel& asset);
// By what has been measured of soils on Earth, of lunar soil and of simulants (Carrier et al. 1991,
// Lunar Sourcebook ch. 9; Wong 2008, table 2.3), with room on both sides.
std::vector<std::string> soil_doubts(const Soil& soil);

}  // namespace lsos
