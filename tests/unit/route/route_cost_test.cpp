// Cost of slowing down for arcs, against the motion itself.
#include "route/cost/route_cost.h"

#include <gtest/gtest.h>

#include "route/search/dubins_path.h"
#include "unit/route/test_rover.h"

namespace lsos::test {
namespace {

// Time beyond that at full speed of a rover whose speed, as a share of full speed, changes by 1 /
// stop_s a second: from the end of an arc at `was`, over `free_m` and an arc of `length_m` at
// `now`, speeding up between as long as it can still slow down in time.
double longer_s(double was, double now, double free_m, double length_m, double speed_mps,
                double stop_s) {
  constexpr double step_s = 1e-5;
  const double rate_mps2 = speed_mps / stop_s;
  double at_m = 0, v_mps = was * speed_mps, time_s = 0;
  while (at_m < free_m + length_m) {
    const double left_m = std::max(0.0, free_m - at_m), arc_mps = now * speed_mps;
    const double most_mps =
        std::min(speed_mps, std::sqrt(arc_mps * arc_mps + 2 * rate_mps2 * left_m));
    v_mps = std::min(v_mps + rate_mps2 * step_s, most_mps);
    at_m += v_mps * step_s;
    time_s += step_s;
  }
  return time_s - (free_m + length_m) / speed_mps;
}

// A rover that cannot turn on the spot, on level ground.
struct OnLevel {
  explicit OnLevel(const DriveCost& of) : cost(of) {}

  Site site{{}};
  DriveCost cost;
  GroundMap map{site.ground(),
                MapFrame(site.ground().site(), {0, 0, 0}),
                {-20, -20},
                {20, 20},
                map_spacing_m(cost)};
  StanceFinder finder{cost};
  RouteCost costs{map, finder, RouteAim::energy};
};
DriveCost turning_rover() {
  DriveCost cost = simple_rover();
  cost.can_turn_on_spot = false;
  cost.stop_s = 4;
  cost.load_w = 1;
  cost.turning_radius_min_m = 1;
  return cost;
}

TEST(RouteCost, tells_how_long_arcs_take_that_follow_each_other) {
  DriveCost cost = turning_rover();
  cost.speed_mps = 2;
  cost.acceleration_mps2 = 0.5;
  const OnLevel rover(cost);
  const RouteCost& costs = rover.costs;
  const auto share = [&](double radius_m) {
    return arc_speed_mps(cost, radius_m) / cost.speed_mps;
  };
  struct Case {
    double before_m, radius_m, free_m;
  };
  for (const Case& of :
       {Case{1, 6, 0}, Case{6, 1, 8}, Case{2, 2, 3}, Case{1, 6, 1}, Case{3, 3, 40}}) {
    RouteCost::ArcState speeds{share(of.before_m), of.free_m};
    constexpr double bend_rad = 1;
    const double told_s = costs.arc(speeds, of.radius_m, bend_rad);
    const double moved_s = longer_s(share(of.before_m), share(of.radius_m), of.free_m,
                                    of.radius_m * bend_rad, cost.speed_mps, cost.stop_s);
    EXPECT_NEAR(told_s, moved_s, 0.01) << of.before_m << " " << of.radius_m << " " << of.free_m;
    EXPECT_EQ(speeds.share, share(of.radius_m));
    EXPECT_EQ(speeds.free_m, 0);
  }
}

// With a bound the evaluation of a piece stops early, which must not change costs below the bound.
TEST(RouteCost, are_told_in_full_up_to_what_they_may_be) {
  DriveCost cost = turning_rover();
  cost.slow_j = 30;
  OnLevel rover(cost);
  RouteCost& costs = rover.costs;
  const Line2 bent{{0, 0}, {5, 0}, {9, 3}, {9, 8}};
  const double pieces = costs.along(bent);
  ASSERT_GT(costs.driven(bent), pieces);  // by the cost of the arcs
  EXPECT_EQ(costs.along(bent, 1.001 * pieces), pieces);
  EXPECT_EQ(costs.along(bent, 0.999 * pieces), RouteCost::unlimited);
}

// An arc costs the same in pieces as in one, but not if each piece begins at full speed.
TEST(RouteCost, count_arcs_across_the_pieces_of_a_line) {
  DriveCost cost = turning_rover();
  cost.speed_mps = 2;
  cost.slow_j = 30;
  const OnLevel rover(cost);
  const RouteCost& costs = rover.costs;
  const Line2 whole = arc_line({{0, 0}, 0}, 0.4, 4, 0.5);
  ASSERT_GT(whole.size(), 6u);
  RouteCost::ArcState at_once;
  const double cost_at_once = costs.arcs(at_once, whole);
  for (std::size_t cut = 1; cut + 1 < whole.size(); ++cut) {
    const auto middle = whole.begin() + static_cast<std::ptrdiff_t>(cut);
    const Line2 first(whole.begin(), middle + 1), second(middle, whole.end());
    RouteCost::ArcState carried, fresh;
    const double of_first = costs.arcs(carried, first);
    EXPECT_NEAR(of_first + costs.arcs(carried, second), cost_at_once, 1e-9) << cut;
    if (first.size() > 2 && second.size() > 2) {  // both of them bend
      EXPECT_GT(of_first + costs.arcs(fresh, second), cost_at_once) << cut;
    }
  }
  RouteCost::ArcState one, other;
  const Line2 there_twice{{0, 0}, {5, 0}, {5, 0}, {5, 5}}, once{{0, 0}, {5, 0}, {5, 5}};
  EXPECT_EQ(costs.arcs(one, there_twice), costs.arcs(other, once)) << "a piece of no length";
}

}  // namespace
}  // namespace lsos::test
