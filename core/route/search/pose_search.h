// Search over poses for the cheapest route of a rover that cannot turn on the spot.
#pragma once

#include "route/cost/stretch.h"
#include "route/search/corridor.h"
#include "route/search/dubins_path.h"

namespace lsos {

struct PoseRoute {
  Stretches stretches;       // from the start to the goal, poses joined by arcs; empty: none
  double cost = 0;           // infinite where there is none
  double weight = 1;         // heuristic weight: `cost` is at most about this many times the least
  Vec2 nearest_m;            // the place nearest to the goal that was reached
  std::size_t expanded = 0;  // poses
  // Without a route, and with all poses expanded: whether there was none but the start, and whether
  // a wider map may hold a route.
  bool is_start_blocked = false, is_at_border = false;

  bool is_found() const { return !stretches.empty(); }
};

struct PoseGuide {
  const Corridor* within = nullptr;  // corridor whose places alone are used; null: all
  // Coarse resolution: steps and cells twice as long, cost to go over a lattice twice as coarse,
  // and a high heuristic weight from the first. It takes a fraction of the time for routes that
  // refinement makes as good, but its steps may pass over narrow gaps.
  bool is_coarse = false;
  bool may_reverse = false;  // backwards too (Reeds and Shepp 1990)
};

// Hybrid A* (Dolgov et al. 2010) over (x, y, heading, gear). Edges are arcs of `radius_m`, wider
// arcs and straight lines, each beginning in the exact pose in which the last one ended; the last
// piece is an analytic expansion, an arc and a straight line to the goal. In each cell two poses at
// most are expanded: the first reached by a sharp arc, and the first reached otherwise. The
// heuristic weight rises as more poses are expanded, `poses_max` in all; half a million are the
// most that the stages of one detour bound expand. Start and goal must be on the map.
PoseRoute search_poses(RouteCost& costs, const Pose2& start, const Vec2& goal_m, double radius_m,
                       std::size_t poses_max, const PoseGuide& guide = {});

}  // namespace lsos
