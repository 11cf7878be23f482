// Reachability: whether any route over the lattice joins start and goal. It is known long before
// the cheapest route: a goal in a pit is enclosed by little ground.
#pragma once

#include "route/cost/route_cost.h"

namespace lsos {

struct Reachability {
  enum class Answer {
    joined,          // there is a route
    start_enclosed,  // all that can be reached from the start was expanded
    goal_enclosed,   // all from which the goal can be reached was expanded
    given_up,        // neither, within the greatest number of expanded nodes
  };
  Answer answer = Answer::joined;
  bool is_at_border = false;  // the closed side touches the border: a wider map may open it
  std::size_t expanded = 0;   // nodes expanded
  // Where not joined: the reachable place that is nearest to the goal.
  Vec2 nearest_m = Vec2::Zero();
};

// Expands from both ends, always the smaller side, nodes nearest to the other end first, along the
// edges that search_grid() may use: until a side is enclosed or has met the other. Start and goal
// must be on the map; the start is taken at the nearest node. With `only_nearest` the goal is no
// place to drive to, and only the place nearest to it is searched.
Reachability find_reachability(RouteCost& costs, const Vec2& start_m, const Vec2& goal_m,
                               bool only_nearest = false);

}  // namespace lsos
