// A rover that cannot turn on the spot, and grounds with discs that no route leads through.
#pragma once

#include <limits>
#include <vector>

#include "route/cost/route_cost.h"
#include "test_rover.h"

namespace lsos::test {

inline constexpr double pi = std::numbers::pi;

inline DriveCost wide_turner() {
  DriveCost cost = simple_rover();
  cost.can_turn_on_spot = false;
  cost.turning_radius_min_m = 4;
  return cost;
}

inline LegRequest towards(const Vec3& goal_m, double heading_rad) {
  LegRequest request;
  request.goal_S_m = goal_m;
  request.start_heading_rad = heading_rad;
  return request;
}

// Level ground from -10 to 60 m, `aside_m` to either side; discs that no route leads through.
struct OpenGround {
  OpenGround(double aside_m, std::vector<Disc2> avoided, double slope_east_rad = 0)
      : site(Site::slope(slope_east_rad)),
        map(site.ground(), MapFrame(site.ground().site(), Vec3::Zero()), {-10, -aside_m},
            {60, aside_m}, 1),
        costs(map, finder, RouteAim::energy, std::move(avoided)) {}

  Site site;
  DriveCost cost = wide_turner();
  StanceFinder finder{cost};
  GroundMap map;
  RouteCost costs;
};
inline constexpr double turn_m = 4.4;
inline constexpr std::size_t many_poses = 500'000;

// A ring of discs about the origin, open to one side.
inline std::vector<Disc2> ring(double radius_m, double open_at_rad) {
  std::vector<Disc2> discs;
  for (double at_rad = 0; at_rad < 2 * pi; at_rad += 0.05) {
    if (std::abs(std::remainder(at_rad - open_at_rad, 2 * pi)) < 0.3) continue;
    discs.push_back({radius_m * Vec2(std::cos(at_rad), std::sin(at_rad)), 1});
  }
  return discs;
}

}  // namespace lsos::test
