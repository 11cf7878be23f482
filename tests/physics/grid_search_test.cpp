// How much of the lattice a search looks at on level ground, of a shipped rover.
#include "route/grid_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "mission/drive_table.h"
#include "physics/drive.h"
#include "route/leg_cost.h"

namespace lsos::test {
namespace {

// Ways that take the same steps in another order cost the same; of bearings between the lattice's
// own there are as many as places in a parallelogram.
TEST(LevelSearch, looks_at_few_of_the_ways_that_cost_the_same) {
  const auto level = ground({"Moon", PlaneSurface{}, "ApolloNominal"});
  const VehicleConfig rover = rover_on("SEV", *level, "Moon");
  const double g_mps2 = gravity_mps2(*find_body("Moon"), start);
  const DriveCost cost = drive_cost(rover, level->soils(), g_mps2, rover.cruise_speed_mps);
  const StanceFinder finder(cost);
  for (const double bearing_deg : {0.0, 7.0, 18.0, 30.0, 45.0}) {
    GroundMap map(*level, MapFrame(level->site(), Vec3::Zero()), {-100, -100}, {400, 400},
                  map_spacing_m(cost));
    LegCosts costs(map, finder, RouteAim::energy);
    const Vec2 goal_m = 300 * Vec2(std::sin(radians(bearing_deg)), std::cos(radians(bearing_deg)));
    const GridRoute route = search_grid(costs, Vec2::Zero(), goal_m);
    const double steps = octile_m(goal_m) / map.spacing_m();
    EXPECT_LT(static_cast<double>(route.expanded), 4 * steps) << bearing_deg;
  }
}

}  // namespace
}  // namespace lsos::test
