// Planned legs of shipped rovers on shipped terrains: none costs more than a reference search
// finds, and none goes far beyond a limit between the samples at which the planner evaluates the
// ground.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "physics/legs.h"
#include "route/cost/route_cost.h"
#include "route/route_planner.h"

namespace lsos::test {
namespace {

struct Series {
  const char *rover, *terrain;
  double length_m;
  int legs;
};

// Cost of the straight line for a rover that turns on the spot; infinite if that line is not free.
double straight_cost(const Ground& ground, const DriveCost& cost, const LegRequest& request) {
  if (!cost.can_turn_on_spot) return std::numeric_limits<double>::infinity();
  const StanceFinder finder(cost);
  const MapFrame frame(ground.site(), Vec3::Zero());
  const Vec2 goal_m = frame.at(request.goal_S_m);
  const double spacing_m = map_spacing_m(cost);
  const Vec2 reach_m = Vec2::Constant(spacing_m * std::ceil(2 * goal_m.norm() / spacing_m));
  GroundMap map(ground, frame, -reach_m, reach_m, spacing_m);
  RouteCost costs(map, finder, request.aim);
  costs.set_tight({{Vec2::Zero(), 2}, {goal_m, 2}});
  return costs.straight(Vec2::Zero(), goal_m);
}

// Least slope, over all headings of the rover, of the plane fitted by least squares to the ground
// under its wheels. Uses the ground itself, not the planner's map.
double least_slope_rad(const Ground& ground, const DriveCost& cost, const Vec3& at_S_m) {
  Ground::Probe probe(ground);
  const auto wheels = static_cast<Eigen::Index>(cost.wheels_B_m.size());
  double least_rad = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 16; ++k) {
    const Eigen::Rotation2Dd yaw(k * std::numbers::pi / 8);
    Eigen::MatrixX3d places(wheels, 3);
    Eigen::VectorXd heights_m(wheels);
    for (Eigen::Index i = 0; i < wheels; ++i) {
      const Vec2 p_m = yaw * cost.wheels_B_m[static_cast<std::size_t>(i)];
      const Vec3 p_S_m = at_S_m + Vec3(p_m.x(), p_m.y(), 0);
      places.row(i) << p_m.x(), p_m.y(), 1;
      heights_m[i] = p_S_m.z() - probe.sample(p_S_m).gap_m;
    }
    const Vec3 plane = places.colPivHouseholderQr().solve(heights_m);
    least_rad = std::min(least_rad, std::atan(plane.head<2>().norm()));
  }
  return least_rad;
}

class RouteQuality : public testing::TestWithParam<Series> {};

TEST_P(RouteQuality, is_never_costlier_than_the_way_over_the_lattice) {
  const Series& series = GetParam();
  int found = 0, too_steep = 0;
  double sum = 0, worst = 0;
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
    // For a rover that cannot turn on the spot the planner keeps a tenth of its tightest turn for
    // steering.
    const double over_lattice = cost.can_turn_on_spot
                                    ? grid_cost(*ground, cost, request.goal_S_m, request.aim)
                                    : pose_cost(*ground, cost, request);
    const double allowed = cost.can_turn_on_spot ? 1 + 1e-9 : 1.05;
    // A place from which the rover could not start again is no goal, whatever the reference A*
    // finds.
    if (planned.reason.starts_with("the goal is on a slope")) {
      ++too_steep;
      const double least_rad = std::min(cost.limits.slope_max_rad, climb_max_rad(cost.soils[0]));
      EXPECT_GT(least_slope_rad(*ground, cost, request.goal_S_m), 0.9 * least_rad)
          << planned.reason;
      continue;
    }
    if (!planned.is_found()) {
      EXPECT_FALSE(std::isfinite(over_lattice)) << leg.seed << ": " << planned.reason;
      continue;
    }
    ++found;
    EXPECT_LE(planned.cost, over_lattice * allowed) << "seed " << seed;
    if (std::isfinite(over_lattice)) {
      sum += planned.cost / over_lattice;
      worst = std::max(worst, planned.cost / over_lattice);
    }
    EXPECT_LE(planned.cost, straight_cost(*ground, cost, request) * (1 + 1e-9)) << "seed " << seed;
    // Limits are checked at samples other than the planner's; near the given start and goal they
    // are not checked.
    const StanceFinder finder(cost);
    const MapFrame frame(ground->site(), Vec3::Zero());
    const Vec2 reach_m = Vec2::Constant(4 * series.length_m);
    GroundMap map(*ground, frame, -reach_m, reach_m, map_spacing_m(cost));
    for (std::size_t k = 0; k + 1 < planned.path_S_m.size(); ++k) {
      const Vec2 from_m = frame.at(planned.path_S_m[k]);
      const Vec2 segment_m = frame.at(planned.path_S_m[k + 1]) - from_m;
      const double step_m = 0.3 * map_spacing_m(cost);
      for (double at = step_m / 2; at < segment_m.norm(); at += step_m) {
        const Vec2 at_m = from_m + at * segment_m.normalized();
        const Vec2 goal_m = frame.at(request.goal_S_m);
        if (std::min(at_m.norm(), (at_m - goal_m).norm()) < 4) continue;
        const Stance stance = finder.at(map, at_m, segment_m.normalized());
        EXPECT_LT(stance.slope_rad, 1.05 * cost.limits.slope_max_rad);
        EXPECT_LT(stance.unevenness_m, 1.1 * cost.limits.unevenness_max_m);
        EXPECT_GT(stance.clearance_m, 0.9 * cost.limits.clearance_min_m);
      }
    }
  }
  EXPECT_EQ(found, series.legs);
  EXPECT_LT(too_steep, 2 * found);
  std::printf("%d goals too steep to leave, %d legs\n", too_steep, found);
  RecordProperty("cost_to_lattice", fmt::format("{:.4f}", sum / found));
  RecordProperty("worst", fmt::format("{:.4f}", worst));
}

INSTANTIATE_TEST_SUITE_P(
    Legs, RouteQuality,
    testing::Values(Series{"SEV", "Craters", 120, 15}, Series{"SEV", "LunarSouthPole", 120, 10},
                    Series{"MER", "Craters", 40, 15}, Series{"MER", "LunarSouthPole", 40, 10},
                    Series{"LRV", "Craters", 80, 10}, Series{"LRV", "LunarSouthPole", 80, 5},
                    // Long legs are searched in a corridor about a coarser route.
                    Series{"SEV", "Craters", 500, 5}, Series{"SEV", "LunarSouthPole", 500, 5}),
    [](const auto& tested) {
      return fmt::format("{}{}{:.0f}", tested.param.rover, tested.param.terrain,
                         tested.param.length_m);
    });

}  // namespace
}  // namespace lsos::test
