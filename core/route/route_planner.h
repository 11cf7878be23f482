// One leg of a route, planned on the ground that the rover will meet.
#pragma once

#include "route/cost/drive_cost.h"
#include "route/cost/leg_request.h"
#include "terrain/ground.h"

namespace lsos {

// Searches a corridor around the straight line, and a wider one where that holds no route.
PlannedLeg plan_leg(const Ground& ground, const DriveCost& cost, const LegRequest& request);

// Whether the rover can drive straight from one place to another nearby.
bool is_free(const Ground& ground, const DriveCost& cost, const Obstacles& obstacles,
             const Vec3& from_S_m, const Vec3& to_S_m);

}  // namespace lsos
