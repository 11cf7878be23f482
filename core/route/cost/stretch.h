// Stretches of a route, each driven in one gear: forwards or backwards. A rover that cannot turn on
// the spot may back up, as a car does; every other route is one stretch.
#pragma once

#include <numbers>
#include <vector>

#include "route/cost/route_cost.h"

namespace lsos {

struct Stretch {
  std::vector<Pose2> poses;  // yaw: direction of travel, backwards opposite to the heading
  Line2 line;                // the whole of it; empty: not yet laid through the poses
  bool is_backward = false;
};
using Stretches = std::vector<Stretch>;

// Pose of travel of a rover that stands at `rover`; and the reverse.
inline Pose2 travelling(const Pose2& rover, bool is_backward) {
  return {rover.at_m, rover.yaw_rad + (is_backward ? std::numbers::pi : 0)};
}
inline Pose2 standing(const Pose2& travel, bool is_backward) {
  return {travel.at_m, travel.yaw_rad - (is_backward ? std::numbers::pi : 0)};
}

// Cost of driving the lines of all stretches, changes of gear included; infinite where a hazard
// lies on one.
double driven(RouteCost& costs, const Stretches& stretches);
// The same with length, duration, energy, steepest slope and first hazard.
LegSummary summary(RouteCost& costs, const Stretches& stretches);
// RouteCost::hazards() of all stretches.
std::vector<Vec2> hazards(RouteCost& costs, const Stretches& stretches, double apart_m);

}  // namespace lsos
