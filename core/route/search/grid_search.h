// Search for a route over the nodes of a map, each connected to its eight neighbours. Short routes
// are the cheapest there are.
#pragma once

#include "route/cost/route_cost.h"

namespace lsos {

struct GridRoute {
  Line2 line;       // from start to goal; empty: there is none
  double cost = 0;  // infinite where there is none
  Vec2 nearest_m;   // the reachable place nearest to the goal
  std::size_t expanded = 0;
};

// Octile distance: length of the shortest path over nodes, each connected to its eight neighbours.
double octile_m(const Vec2& delta_m);

// Lazy A*, whose edges are evaluated only when they come first in the queue (Cohen, Phillips and
// Likhachev 2014). A long route is searched in a corridor around the route over a coarser map,
// which is found in the same manner. Start and goal must be on the map; the start is taken at the
// nearest node.
GridRoute search_grid(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m);

}  // namespace lsos
