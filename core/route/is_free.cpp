#include <cmath>

#include "route/cost/route_cost.h"
#include "route/cost/standing_obstacles.h"
#include "route/route_planner.h"

namespace lsos {

namespace {

// Half width of the map about the two places.
constexpr double around_m = 20;

}  // namespace

bool is_free(const Ground& ground, const DriveCost& cost, const Obstacles& obstacles,
             const Vec3& from_S_m, const Vec3& to_S_m) {
  const StanceFinder finder(cost);
  const MapFrame frame(ground.site(), from_S_m);
  const Vec2 to_m = frame.at(to_S_m);
  const Vec2 half_width_m = Vec2::Constant(around_m);
  GroundMap map(ground, frame, to_m.cwiseMin(0) - half_width_m, to_m.cwiseMax(0) + half_width_m,
                map_spacing_m(cost));
  RouteCost costs(map, finder, RouteAim::risk);
  costs.set_standing(StandingObstacles(obstacles, frame).footprints(), obstacles.rover_at_rest);
  return costs.is_free(Vec2::Zero(), to_m);
}

}  // namespace lsos
