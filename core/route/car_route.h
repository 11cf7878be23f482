// Planned route of a rover that cannot turn on the spot, as a car cannot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "route/cost/stretch.h"

namespace lsos {

struct CarRoute {
  Stretches stretches;                // empty: no route
  std::vector<std::string> messages;  // OMPL's warnings
  // The stretches before refinement, with poses; empty where it was not refined.
  Stretches before_optimising;
  // Without a route:
  Vec2 nearest_m;                 // the place nearest to the goal that was reached
  bool is_turn_too_wide = false;  // there is a route over the lattice, but none in arcs
  bool is_start_blocked = false;  // the rover can drive neither forwards nor backwards
  bool is_at_border = false;      // a wider map may hold a route

  bool is_found() const { return !stretches.empty(); }
};

// Plans with arcs of `radius_m` or wider; where a coarse search near the lattice route finds none
// forwards, the rover backs up too. `poses_left`: how many poses may be expanded, less those that
// were. `known`: stretches before refinement of the same leg, found with less ground to avoid; if
// they are still free no other route is searched. The same seed gives the same bits.
CarRoute car_route(RouteCost& costs, const DriveCost& cost, const Pose2& start, const Vec2& goal_m,
                   double radius_m, std::uint64_t seed, std::size_t& poses_left,
                   const Stretches& known = {});

}  // namespace lsos
