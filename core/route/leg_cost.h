// What a piece of a route costs: the one function that searching, refining and tests share.
#pragma once

#include <vector>

#include "route/stance.h"

namespace lsos {

using Line2 = std::vector<Vec2>;  // on a map, m

struct LegCost {
  double cost = 0;  // J or m, by the aim; infinite where a hazard lies on it
  double length_m = 0, duration_s = 0, energy_j = 0;
  double slope_max_rad = 0;
  Vec2 steepest_m = Vec2::Zero();
  Hazard hazard = Hazard::none;
  Vec2 hazard_m = Vec2::Zero();  // the first
};

class LegCosts {
 public:
  LegCosts(GroundMap& map, const StanceFinder& finder, RouteAim aim);

  // Of a straight piece, by the midpoint rule in steps of 1.5 spacings of the map at most; infinite
  // where a hazard lies on it.
  double straight(const Vec2& from_m, const Vec2& to_m);
  // The same of a line, with all that is told of it.
  LegCost of(const Line2& line);
  // Whether the rover can stand there, driving ahead (unit).
  bool can_stand(const Vec2& at_m, const Vec2& ahead);
  // Of a metre at least, after `per_rise` for each metre of climb: what guides the search.
  double least_per_metre() const { return least_per_metre_; }
  double per_rise() const { return per_rise_; }
  GroundMap& map() { return map_; }

 private:
  double rate(const Stance& stance) const;
  void find_least();

  GroundMap& map_;
  const StanceFinder& finder_;
  RouteAim aim_;
  double least_per_metre_ = 1, per_rise_ = 0;
};

}  // namespace lsos
