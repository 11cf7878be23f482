// Checks before the run of an event that drives through its waypoints as drawn.
#pragma once

#include <optional>
#include <vector>

#include "base/error.h"
#include "mission/routes/rover_routes.h"
#include "plan/plan.h"

namespace lsos {

// Expected pose of a rover; absent: not known.
struct ExpectedPose {
  std::optional<Vec3> p_S_m;
  std::optional<double> heading_rad;  // clockwise from north
};

// Warnings about the first leg without ground, the first through an obstacle, the steepest ground
// beyond the rover's limits, a lack of room to turn, the first waypoint inside the turning circle,
// and a line that leads nowhere.
std::vector<Fault> drawn_route_warnings(const PlanEvent& event, const EventDeclaration& declaration,
                                        const Path3& waypoints_S_m, const ExpectedPose& start,
                                        RoverRoutes& routes, const Ground& ground);

}  // namespace lsos
