#include "route/route_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "route/grid_search.h"

namespace lsos {

namespace {

// A map has so many nodes over the shortest side of the rectangle of its wheels, within bounds.
constexpr double nodes_a_side = 4, spacing_min_m = 0.2, spacing_max_m = 1;
// Corridors, in lengths of the leg to either side; and never less than this.
constexpr double corridors[] = {0.25, 1, 2.5};
constexpr double corridor_min_m = 20;
constexpr int directions = 16;

// The best stance that a rover can take at a place, turning there.
Stance best_stance(GroundMap& map, const StanceFinder& finder, const Vec2& at_m) {
  Stance best;
  Hazard least = Hazard::no_ground;
  for (int k = 0; k < directions; ++k) {
    const double yaw_rad = 2 * std::numbers::pi * k / directions;
    const Stance stance = finder.at(map, at_m, {std::cos(yaw_rad), std::sin(yaw_rad)});
    const Hazard now = hazard(stance, finder.cost());
    if (now == Hazard::none) return stance;
    if (k == 0 || least == Hazard::no_ground) {
      best = stance;
      least = now;
    }
  }
  return best;
}

std::string say(Hazard hazard, const Stance& stance, const DriveCost& cost) {
  const DriveLimits& limits = cost.limits;
  switch (hazard) {
    case Hazard::none:
      return "free";
    case Hazard::no_ground:
      return "without ground";
    case Hazard::slope:
      return fmt::format("on a slope of {:.0f} degrees, {:.0f} are allowed",
                         degrees(stance.slope_rad), degrees(limits.slope_max_rad));
    case Hazard::uneven:
      return fmt::format("uneven by {:.2f} m at a wheel, {:.2f} are allowed", stance.unevenness_m,
                         limits.unevenness_max_m);
    case Hazard::clearance:
      return fmt::format("with {:.2f} m under the chassis, {:.2f} are wanted", stance.clearance_m,
                         limits.clearance_min_m);
    case Hazard::climb:
      return fmt::format("on a slope of {:.0f} degrees, its wheels climb {:.0f} on this soil",
                         degrees(stance.slope_rad),
                         degrees(cost.soils[static_cast<std::size_t>(stance.soil)].last_rad()));
  }
  return {};
}

// "" where the rover can stand.
std::string fault_at(GroundMap& map, const StanceFinder& finder, const Vec2& at_m) {
  const Stance stance = best_stance(map, finder, at_m);
  const Hazard found = hazard(stance, finder.cost());
  return found == Hazard::none ? "" : say(found, stance, finder.cost());
}

Vec3 on_ground(GroundMap& map, Ground::Probe& probe, const Vec2& at_m) {
  const Vec3 p_S_m = map.frame().p_S_m(at_m);
  const GroundSample sample = probe.sample(p_S_m);
  return sample.is_ground() ? Vec3(p_S_m - sample.gap_m * sample.up_S) : p_S_m;
}

}  // namespace

double map_spacing_m(const DriveCost& cost) {
  Vec2 low_m = cost.wheels_B_m.front(), high_m = low_m;
  for (const Vec2& wheel : cost.wheels_B_m) {
    low_m = low_m.cwiseMin(wheel);
    high_m = high_m.cwiseMax(wheel);
  }
  return std::clamp((high_m - low_m).minCoeff() / nodes_a_side, spacing_min_m, spacing_max_m);
}

PlannedLeg plan_leg(const Ground& ground, const DriveCost& cost, const LegRequest& request) {
  PlannedLeg leg;
  const StanceFinder finder(cost);
  const double spacing_m = map_spacing_m(cost);
  const MapFrame frame(ground.site(), request.start_S_m);
  const Vec2 start_m = Vec2::Zero(), goal_m = frame.at(request.goal_S_m);
  const double length_m = goal_m.norm();
  Ground::Probe probe(ground);
  for (const double share : corridors) {
    const double aside_m = std::max(corridor_min_m, share * length_m);
    // The start is one of the nodes.
    const auto whole = [&](const Vec2& at_m) -> Vec2 {
      return spacing_m * (at_m / spacing_m).array().floor().matrix();
    };
    GroundMap map(ground, frame, whole(start_m.cwiseMin(goal_m) - Vec2::Constant(aside_m)),
                  start_m.cwiseMax(goal_m) + Vec2::Constant(aside_m), spacing_m);
    const auto refuse = [&](const std::string& reason, const Vec2& nearest_m) {
      leg.reason = reason;
      leg.nearest_S_m = on_ground(map, probe, nearest_m);
      return leg;
    };
    const std::string at_start = fault_at(map, finder, start_m);
    if (!at_start.empty()) return refuse("the start is " + at_start, start_m);
    LegCosts costs(map, finder, request.aim);
    const GridRoute way = search_grid(costs, start_m, goal_m);
    if (way.line.empty()) {
      const std::string at_goal = fault_at(map, finder, goal_m);
      if (!at_goal.empty()) return refuse("the goal is " + at_goal, way.nearest_m);
      if (share < *std::prev(std::end(corridors))) continue;
      const Vec2 on_m = way.nearest_m + (goal_m - way.nearest_m).normalized() * 2 * spacing_m;
      const std::string beyond = fault_at(map, finder, on_m);
      return refuse(
          fmt::format("no way comes nearer to the goal than {:.0f} m; ahead the ground is {}",
                      (goal_m - way.nearest_m).norm(), beyond.empty() ? "cut off" : beyond),
          way.nearest_m);
    }
    const Refined better = refined(costs, way.line, request.seed);
    const LegCost told = costs.of(better.line);
    leg.cost = told.cost;
    leg.length_m = told.length_m;
    leg.duration_s = told.duration_s;
    leg.energy_j = told.energy_j;
    leg.slope_max_rad = told.slope_max_rad;
    leg.steepest_S_m = on_ground(map, probe, told.steepest_m);
    leg.messages = better.messages;
    for (const Vec2& at_m : better.line) leg.path_S_m.push_back(on_ground(map, probe, at_m));
    return leg;
  }
  return leg;
}

}  // namespace lsos
