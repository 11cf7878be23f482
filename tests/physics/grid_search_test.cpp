// Number of nodes that a search expands on level and on rough ground, for a shipped rover.
#include "route/search/grid_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "mission/routes/drive_cost_model.h"
#include "physics/drive.h"
#include "physics/legs.h"
#include "planet/ellipsoid.h"
#include "route/cost/route_cost.h"
#include "route/search/cost_to_go.h"

namespace lsos::test {
namespace {

// Routes that take the same steps in another order cost the same. For a bearing between the
// lattice's own there are as many nodes on them as in a parallelogram; the tie-break must avoid
// most of them.
TEST(LevelSearch, looks_at_few_of_the_ways_that_cost_the_same) {
  const auto level = ground({"Moon", PlaneSurface{}, "ApolloNominal"});
  const VehicleConfig rover = rover_on("SEV", *level, "Moon");
  const double g_mps2 = gravity_mps2(*find_body("Moon"), start);
  const DriveCost cost = drive_cost(rover, level->soils(), g_mps2, rover.cruise_speed_mps);
  const StanceFinder finder(cost);
  for (const double bearing_deg : {0.0, 7.0, 18.0, 30.0, 45.0}) {
    GroundMap map(*level, MapFrame(level->site(), Vec3::Zero()), {-100, -100}, {400, 400},
                  map_spacing_m(cost));
    RouteCost costs(map, finder, RouteAim::energy);
    const Vec2 goal_m = 300 * Vec2(std::sin(radians(bearing_deg)), std::cos(radians(bearing_deg)));
    const GridRoute route = search_grid(costs, Vec2::Zero(), goal_m);
    const double steps = octile_m(goal_m) / map.spacing_m();
    EXPECT_LT(static_cast<double>(route.expanded), 4 * steps) << bearing_deg;
  }
}

// Compared with a search backwards from the goal, which expands every node of the map that it must.
TEST(RoughSearch, near_a_coarser_way_costs_hardly_more_and_looks_at_less) {
  for (const std::uint64_t seed : {4, 6, 9, 13}) {
    const SeededLeg leg{"SEV", "LunarSouthPole", seed, 800};
    const auto ground = leg.ground();
    const DriveCost cost = cost_of(leg, *ground);
    const StanceFinder finder(cost);
    const MapFrame frame(ground->site(), Vec3::Zero());
    const Vec2 goal_m = frame.at(leg.goal_S_m(*ground));
    const double spacing_m = map_spacing_m(cost);
    const Vec2 aside_m = Vec2::Constant(240 * spacing_m);
    const Vec2 low_m = (goal_m.cwiseMin(0) / spacing_m).array().floor().matrix() * spacing_m;
    GroundMap map(*ground, frame, low_m - aside_m, goal_m.cwiseMax(0) + aside_m, spacing_m);
    RouteCost costs(map, finder, seed == 13 ? RouteAim::risk : RouteAim::energy);
    const GridRoute route = search_grid(costs, Vec2::Zero(), goal_m);
    const double cheapest = CostToGo(costs, Vec2::Zero(), goal_m).at(Vec2::Zero());
    ASSERT_TRUE(std::isfinite(cheapest)) << seed;
    EXPECT_LT(route.cost, 1.02 * cheapest) << seed;
    const auto nodes =
        static_cast<std::size_t>(map.columns()) * static_cast<std::size_t>(map.rows());
    EXPECT_LT(route.expanded, nodes / 30) << seed;
    std::printf("seed %d: %.4f of the cheapest, %zu of %zu nodes\n", static_cast<int>(seed),
                route.cost / cheapest, route.expanded, nodes);
  }
}

}  // namespace
}  // namespace lsos::test
