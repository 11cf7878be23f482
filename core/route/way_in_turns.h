// The way of a rover that cannot turn on the spot.
#pragma once

#include <cstdint>
#include <optional>

#include "route/refine/refine.h"
#include "route/search/turning.h"

namespace lsos {

struct WayInTurns {
  std::optional<Refined> way;
  std::vector<Pose2> unrefined;  // what it was before it was refined; empty where it was not
  // Without one:
  Vec2 nearest_m;                 // of all places that were reached the one nearest to the goal
  bool is_turn_too_wide = false;  // there is one over the lattice
  bool is_at_border = false;      // a wider map may hold one
};

// In turns of `radius_m` or wider. `known`: an unrefined way of the same leg, found where less was
// to be kept off; if it is still free no other is looked for. The same seed gives the same bits.
WayInTurns way_in_turns(LegCosts& costs, const DriveCost& cost, const Pose2& start,
                        const Vec2& goal_m, double radius_m, std::uint64_t seed,
                        const std::vector<Pose2>& known = {});

}  // namespace lsos
