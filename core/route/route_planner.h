// One leg of a route, planned on the ground that the rover will meet.
#pragma once

#include <string>

#include "route/refine.h"

namespace lsos {

struct LegRequest {
  Vec3 start_S_m = Vec3::Zero(), goal_S_m = Vec3::Zero();
  RouteAim aim = RouteAim::energy;
  std::uint64_t seed = 0;
};

struct PlannedLeg {
  Path3 path_S_m;  // from start to goal, on the ground; empty when there is none
  double cost = 0, length_m = 0, duration_s = 0, energy_j = 0, slope_max_rad = 0;
  Vec3 steepest_S_m = Vec3::Zero();
  std::vector<std::string> messages;

  // Why there is none ("the goal is too steep: 31 degrees"), and the place nearest to the goal that
  // can be reached.
  std::string reason;
  Vec3 nearest_S_m = Vec3::Zero();

  bool is_found() const { return !path_S_m.empty(); }
};

// Spacing of the map that a rover is planned on, m: features that its wheels feel are on it.
double map_spacing_m(const DriveCost& cost);

// Looks in a corridor about the straight line, in a wider one where that holds no way.
PlannedLeg plan_leg(const Ground& ground, const DriveCost& cost, const LegRequest& request);

}  // namespace lsos
