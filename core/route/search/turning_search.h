// The cheapest way over poses for a rover that cannot turn on the spot.
#pragma once

#include "route/search/tube.h"
#include "route/search/turning.h"

namespace lsos {

struct TurningRoute {
  std::vector<Pose2> poses;  // from the start to the goal, joined by arcs
  Line2 line;                // all of it, with its arcs drawn out; empty: there is none
  double cost = 0;           // infinite where there is none
  double haste = 1;          // it costs about so many times the cheapest at most, by a fine guide
  Vec2 nearest_m;            // of all places that were reached the one nearest to the goal
  // There is none, with all poses looked at: whatever they were guided by, there are no others; and
  // a wider map may hold one.
  bool is_shut_in = false, is_at_border = false;
};

struct TurningGuide {
  const Tube* within = nullptr;  // by its places only
  // By steps and cells twice as long and what is left to the goal over a lattice twice as coarse,
  // in haste from the first: in a fraction of the time, for ways that refining makes as good, but
  // not where those pass over what there is.
  bool is_coarse = false;
};

// A* over (x, y, heading) whose edges are arcs of `radius_m`, wider ones and straight pieces, each
// beginning in the very pose that the last one ended in (hybrid A*, Dolgov et al. 2010), and whose
// last piece is an arc and a straight line to the goal. Of poses in one cell only the first that
// comes by a sharp arc is followed and the first that does not, and no more than `poses_max` in
// all: the more of them it takes, the costlier a way may be, up to `haste`; half a million is the
// most that are ever looked at. Start and goal must be on the map.
TurningRoute search_turning(LegCosts& costs, const Pose2& start, const Vec2& goal_m,
                            double radius_m, std::size_t poses_max, const TurningGuide& guide = {});

}  // namespace lsos
