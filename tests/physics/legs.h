// Legs over shipped terrains, by seed, planned and searched by other means.
#pragma once

#include <memory>
#include <string>

#include "route/route_planner.h"

namespace lsos::test {

// From a place of a shipped terrain on the Moon so far in a direction that the seed decides.
struct SeededLeg {
  std::string rover, terrain;
  std::uint64_t seed = 0;
  double length_m = 100;

  Geodetic start() const;
  std::unique_ptr<Ground> ground() const;
  // In the ground's site frame, from its origin.
  Vec3 goal_S_m(const Ground& ground) const;
};

// What planning knows of the rover there.
DriveCost cost_of(const SeededLeg& leg, const Ground& ground);

// Cost of the cheapest way over the lattice of the leg's map to each of eight neighbours, by a
// plain A* that has only the costs and their bound in common with the planner's; infinite: none.
double grid_cost(const Ground& ground, const DriveCost& cost, const Vec3& goal_S_m, RouteAim aim);

// The same over (x, y, heading) for a rover that cannot turn on the spot: straight steps and arcs
// of its tightest turn and of wider ones, slowing down for them counted.
double pose_cost(const Ground& ground, const DriveCost& cost, const LegRequest& request);

}  // namespace lsos::test
