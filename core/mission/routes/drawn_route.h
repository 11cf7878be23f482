// What is foreseen of an event that drives through its waypoints as they are drawn.
#pragma once

#include <optional>
#include <vector>

#include "base/error.h"
#include "mission/routes/rover_routes.h"
#include "plan/plan.h"

namespace lsos {

// Where a rover is expected to be.
struct ExpectedPose {
  std::optional<Vec3> p_S_m;
  std::optional<double> heading_rad;  // clockwise from north
};

// Warnings: of the first leg without ground, of the first through something that stands there, of
// the steepest ground beyond the rover, and of the first waypoint inside its turning circle.
std::vector<Fault> drawn_route_warnings(const PlanEvent& event, const Path3& waypoints_S_m,
                                        const ExpectedPose& start, RoverRoutes& routes,
                                        const Ground& ground);

}  // namespace lsos
