// Why a rover cannot be at a place, in words: what was found there, what is allowed.
#pragma once

#include <string>

#include "route/cost/stance.h"

namespace lsos {

// Of all directions that a rover can stand in at a place the one without a hazard, or the least
// demanding.
Stance best_stance(GroundMap& map, const StanceFinder& finder, const Vec2& at_m);

std::string say(Hazard hazard, const Stance& stance, const DriveCost& cost);

// "" where the rover can stand in some direction.
std::string fault_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m);
// "" where it can also stop.
std::string fault_to_stop_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m);
// Driving ahead (unit).
std::string fault_ahead(GroundMap& map, const StanceFinder& finder, const Vec2& at_m,
                        const Vec2& ahead);

}  // namespace lsos
