// The cheapest way over poses for a rover that cannot turn on the spot.
#pragma once

#include "route/turning.h"

namespace lsos {

struct TurningRoute {
  std::vector<Pose2> poses;  // from the start to the goal, joined by arcs
  Line2 line;                // all of it, with its arcs drawn out; empty: there is none
  double cost = 0;           // infinite where there is none
  Vec2 nearest_m;            // of all places that were reached the one nearest to the goal
  bool is_cut_off = false;   // not even a rover that turns on the spot gets there
};

// A* over (x, y, heading) whose edges are arcs of `radius_m`, wider ones and straight pieces, each
// beginning in the very pose that the last one ended in (hybrid A*, Dolgov et al. 2010), and whose
// last piece is an arc and a straight line to the goal. Of poses in one cell only the first that
// comes by a sharp arc is followed and the first that does not, and no more than `reached_max` in
// all. Start and goal must be on the map.
TurningRoute search_turning(LegCosts& costs, const Pose2& start, const Vec2& goal_m,
                            double radius_m, std::size_t reached_max);

}  // namespace lsos
