// Whether any way over the lattice joins start and goal, found long before the cheapest is looked
// for: a goal in a pit is shut in by little ground.
#pragma once

#include "route/cost/leg_cost.h"

namespace lsos {

struct Reach {
  enum class Answer {
    joined,        // there is a way
    start_closed,  // all that can be reached from the start was looked at
    goal_closed,   // all from where the goal can be reached
    given_up,      // neither, and more nodes were looked at than is worth it
  };
  Answer answer = Answer::joined;
  bool is_at_border = false;  // of what is closed: a wider map may open it
  std::size_t looked_at = 0;  // nodes
  Vec2 nearest_m =
      Vec2::Zero();  // where it is not joined: the nearest to the goal that can be reached
};

// Looks from both ends in turn, at what is nearest to the other end first, over the pieces that
// search_grid() may take: each side stops where it is shut in, or has met the other. Start and goal
// must be on the map; the start is taken at the nearest node.
// `only_nearest`: the goal is no place to go to; only what is nearest to it is looked for.
Reach look_for_reach(LegCosts& costs, const Vec2& start_m, const Vec2& goal_m,
                     bool only_nearest = false);

}  // namespace lsos
