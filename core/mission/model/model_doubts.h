// Numbers of rovers, assets and soils that can be simulated and are yet likely to be mistakes, such
// as another unit. One sentence each; empty when there are none.
#pragma once

#include <string>
#include <vector>

#include "mission/model/rover_model.h"
#include "terrain/spec/soil.h"

namespace lsos {

// Numbers are judged by the rover's own size, mass, speed and loads.
std::vector<std::string> rover_doubts(const RoverModel& rover);
std::vector<std::string> asset_doubts(const AssetModel& asset);
// The bounds include all soils of the literature in terrain/soils, with room on both sides.
std::vector<std::string> soil_doubts(const Soil& soil);

// Greatest height above the ground at which a mast that can be brought along holds an antenna, m.
inline constexpr double highest_mast_m = 100;

}  // namespace lsos
