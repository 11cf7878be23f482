// Planned route of a rover that cannot turn on the spot.
#pragma once

#include <cstdint>
#include <optional>

#include "route/refine/optimise.h"
#include "route/search/dubins_path.h"

namespace lsos {

struct DubinsRoute {
  std::optional<OptimisedRoute> route;
  std::vector<Pose2>
      before_optimising;  // its poses before refinement; empty where it was not refined
  // Without a route:
  Vec2 nearest_m;                 // the place nearest to the goal that was reached
  bool is_turn_too_wide = false;  // there is a route over the lattice, but none in arcs
  bool is_at_border = false;      // a wider map may hold a route
};

// Plans with arcs of `radius_m` or wider. `known`: poses before refinement of the same leg, found
// with less ground to avoid; if they are still free no other route is searched. The same seed gives
// the same bits.
DubinsRoute dubins_route(RouteCost& costs, const DriveCost& cost, const Pose2& start,
                         const Vec2& goal_m, double radius_m, std::uint64_t seed,
                         const std::vector<Pose2>& known = {});

}  // namespace lsos
