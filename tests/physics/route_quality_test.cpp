// Planned legs of shipped rovers on shipped terrains: none costs more than another search finds,
// and none goes far beyond a limit between the steps in which the planner looks at the ground.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "physics/legs.h"
#include "route/leg_cost.h"
#include "route/route_planner.h"

namespace lsos::test {
namespace {

struct Series {
  const char *rover, *terrain;
  double length_m;
  int legs;
};

class RouteQuality : public testing::TestWithParam<Series> {};

TEST_P(RouteQuality, is_never_costlier_than_the_way_over_the_lattice) {
  const Series& series = GetParam();
  int found = 0;
  double sum = 0;
  for (std::uint64_t seed = 1; found < series.legs && seed < 1000; ++seed) {
    const SeededLeg leg{series.rover, series.terrain, seed, series.length_m};
    const auto ground = leg.ground();
    const DriveCost cost = cost_of(leg, *ground);
    LegRequest request;
    request.goal_S_m = leg.goal_S_m(*ground);
    request.aim = seed % 2 == 0 ? RouteAim::energy : RouteAim::risk;
    request.seed = seed;
    request.start_heading_rad = 0.1 * static_cast<double>(seed);
    const PlannedLeg planned = plan_leg(*ground, cost, request);
    // A rover that cannot turn on the spot keeps a tenth of its tightest turn for steering.
    const double over_lattice = cost.can_turn_on_spot
                                    ? grid_cost(*ground, cost, request.goal_S_m, request.aim)
                                    : pose_cost(*ground, cost, request);
    const double allowed = cost.can_turn_on_spot ? 1 + 1e-9 : 1.05;
    if (!planned.is_found()) {
      EXPECT_FALSE(std::isfinite(over_lattice)) << leg.seed << ": " << planned.reason;
      continue;
    }
    ++found;
    EXPECT_LE(planned.cost, over_lattice * allowed) << "seed " << seed;
    if (std::isfinite(over_lattice)) sum += planned.cost / over_lattice;
    // What is forbidden, looked for at steps of its own.
    const StanceFinder finder(cost);
    const MapFrame frame(ground->site(), Vec3::Zero());
    const Vec2 reach_m = Vec2::Constant(4 * series.length_m);
    GroundMap map(*ground, frame, -reach_m, reach_m, map_spacing_m(cost));
    for (std::size_t k = 0; k + 1 < planned.path_S_m.size(); ++k) {
      const Vec2 from_m = frame.at(planned.path_S_m[k]);
      const Vec2 way_m = frame.at(planned.path_S_m[k + 1]) - from_m;
      for (double share = 0.05; share < 1; share += 0.1) {
        const Stance stance = finder.at(map, from_m + share * way_m, way_m.normalized());
        // Between the steps of the planner a limit may be passed by a little.
        EXPECT_LT(stance.slope_rad, 1.15 * cost.limits.slope_max_rad);
        EXPECT_LT(stance.unevenness_m, 1.3 * cost.limits.unevenness_max_m);
        EXPECT_GT(stance.clearance_m, 0.5 * cost.limits.clearance_min_m);
      }
    }
  }
  EXPECT_EQ(found, series.legs);
  RecordProperty("cost_to_lattice", fmt::format("{:.4f}", sum / found));
}

INSTANTIATE_TEST_SUITE_P(
    Legs, RouteQuality,
    testing::Values(Series{"SEV", "Craters", 120, 15}, Series{"SEV", "LunarSouthPole", 120, 10},
                    Series{"MER", "Craters", 40, 15}, Series{"MER", "LunarSouthPole", 40, 10},
                    Series{"LRV", "Craters", 80, 10}, Series{"LRV", "LunarSouthPole", 80, 5}),
    [](const auto& tested) { return std::string(tested.param.rover) + tested.param.terrain; });

}  // namespace
}  // namespace lsos::test
