// A way over the nodes of a map, to each of a node's eight neighbours: the cheapest of a short one.
#pragma once

#include "route/cost/leg_cost.h"

namespace lsos {

struct GridRoute {
  Line2 line;       // from start to goal; empty: there is none
  double cost = 0;  // infinite where there is none
  Vec2 nearest_m;   // of all places that can be reached the one nearest to the goal
  std::size_t expanded = 0;
};

// Length of the shortest way over nodes, each to its eight neighbours.
double octile_m(const Vec2& way_m);

// A* whose edges are worked out only when they come first (Cohen, Phillips and Likhachev 2014); a
// long way near that over a coarser map, which is found in the same manner. Start and goal must be
// on the map; the start is taken at the nearest node.
GridRoute search_grid(LegCosts& costs, const Vec2& start_m, const Vec2& goal_m);

}  // namespace lsos
