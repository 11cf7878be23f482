// Numbers of rovers, assets and soils that can be simulated, and yet are likely to be slips: in
// another unit, or of another thing. One sentence each; empty when all is well.
#pragma once

#include <string>
#include <vector>

#include "mission/model/rover_model.h"
#include "terrain/spec/soil.h"

namespace lsos {

// Each is judged by the rover's own size, mass, speed and loads.
std::vector<std::string> rover_doubts(const RoverModel& rover);
std::vector<std::string> asset_doubts(const AssetModel& asset);
// The bounds hold all soils of the literature in terrain/soils, with room on both sides.
std::vector<std::string> soil_doubts(const Soil& soil);

// No mast that can be brought along holds an antenna higher above the ground.
inline constexpr double highest_mast_m = 100;

}  // namespace lsos
