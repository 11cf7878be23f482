// Legs over shipped terrains, chosen by seed, and reference searches for their cheapest routes.
#pragma once

#include <memory>
#include <string>

#include "route/route_planner.h"

namespace lsos::test {

// A leg from a place of a shipped terrain on the Moon, of given length, in a direction drawn from
// the seed.
struct SeededLeg {
  std::string rover, terrain;
  std::uint64_t seed = 0;
  double length_m = 100;

  Geodetic start() const;
  std::unique_ptr<Ground> ground() const;
  // Goal in the ground's site frame; the leg starts at its origin.
  Vec3 goal_S_m(const Ground& ground) const;
};

// Drive cost model of the rover, as planning uses it there.
DriveCost cost_of(const SeededLeg& leg, const Ground& ground);

// Cost of the cheapest route over the lattice of the leg's map, with steps to eight neighbours, by
// a plain A* that shares only the costs and their lower bound with the planner's; infinite if there
// is none.
double grid_cost(const Ground& ground, const DriveCost& cost, const Vec3& goal_S_m, RouteAim aim);

// The same over (x, y, heading) for a rover that cannot turn on the spot: straight steps, and arcs
// of its tightest turn and of wider ones, including the cost of slowing down for them.
double pose_cost(const Ground& ground, const DriveCost& cost, const LegRequest& request);

}  // namespace lsos::test
