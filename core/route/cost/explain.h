// Explains in words why a rover cannot be at a place: what was found there and what is allowed.
#pragma once

#include <string>

#include "route/cost/stance.h"

namespace lsos {

// Stance at a place in a direction without a hazard; where there is none, the one that uses the
// least of its limits.
Stance best_stance(GroundMap& map, const StanceFinder& finder, const Vec2& at_m);

std::string describe(Hazard hazard, const Stance& stance, const DriveCost& cost);

// Why the rover cannot stand at a place; "" where it can in some direction.
std::string fault_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m);
// The same, or why it cannot stop there; "" where it can.
std::string fault_to_stop_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m);
// Why the rover cannot be there driving along `ahead` (unit vector); "" where it can.
std::string fault_ahead(GroundMap& map, const StanceFinder& finder, const Vec2& at_m,
                        const Vec2& ahead);

}  // namespace lsos
