// Planned legs: against another search with the same costs, around obstacles, and reasons for
// failure.
#include "route/route_planner.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <queue>

#include "route/search/grid_search.h"
#include "test_rover.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// A crater that is too steep, a hill that is not, and smaller craters.
std::vector<Form> rough() {
  return {{30, 4, 24, 5, 0.5}, {62, -12, 40, 0, 5}, {50, 18, 12, 2.5, 0.3}, {80, 6, 16, 3, 0.4}};
}

// Dijkstra's search over all edges, without a heuristic and without lazy evaluation.
double dijkstra_cost(RouteCost& costs, const Vec2& goal_m) {
  GroundMap& map = costs.map();
  const auto number = [&](int x, int y) { return static_cast<std::size_t>(y * map.columns() + x); };
  std::vector<double> cost(static_cast<std::size_t>(map.columns() * map.rows()),
                           std::numeric_limits<double>::infinity());
  using Entry = std::tuple<double, int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const Vec2 start = -map.low_m() / map.spacing_m();
  const int x0 = static_cast<int>(std::lround(start.x())),
            y0 = static_cast<int>(std::lround(start.y()));
  cost[number(x0, y0)] = 0;
  queue.push({0, x0, y0});
  double best = std::numeric_limits<double>::infinity();
  while (!queue.empty()) {
    const auto [at, x, y] = queue.top();
    queue.pop();
    if (at > cost[number(x, y)]) continue;
    const Vec2 here_m = map.place_m(x, y);
    if ((here_m - goal_m).cwiseAbs().maxCoeff() <= map.spacing_m()) {
      best = std::min(best, at + costs.straight(here_m, goal_m));
    }
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int u = x + dx, v = y + dy;
        if ((dx == 0 && dy == 0) || u < 0 || v < 0 || u >= map.columns() || v >= map.rows())
          continue;
        const double next = at + costs.straight(here_m, map.place_m(u, v));
        if (!(next < cost[number(u, v)])) continue;
        cost[number(u, v)] = next;
        queue.push({next, u, v});
      }
    }
  }
  return best;
}

TEST(GridSearch, finds_what_dijkstra_finds) {
  const Site site(rough());
  const StanceFinder finder(simple_rover());
  for (const RouteAim aim : {RouteAim::energy, RouteAim::risk}) {
    // The last two are short enough to be searched on this map alone.
    for (const Vec2& goal_m : {Vec2(100, 0), Vec2(90.3, 20.7), Vec2(60, 25), Vec2(70.2, 0)}) {
      GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-20, -40}, {120, 40},
                    0.5);
      RouteCost costs(map, finder, aim);
      const GridRoute route = search_grid(costs, {0, 0}, goal_m);
      const double other = dijkstra_cost(costs, goal_m);
      ASSERT_TRUE(std::isfinite(other));
      // The lower bound uses heights of nodes only; a long route is searched in a corridor around
      // that over a coarser map.
      EXPECT_GT(route.cost, (1 - 2e-3) * other);
      EXPECT_LT(route.cost, (octile_m(goal_m) < 75 ? 1 + 2e-3 : 1.02) * other)
          << goal_m.transpose();
      EXPECT_NEAR(costs.of(route.line).cost, route.cost, 1e-9 * other);
    }
  }
}

// A wall too thin for the steps of a coarser map closes the corridor around the route over that
// map.
TEST(GridSearch, goes_around_what_a_coarser_map_does_not_show) {
  const Site site({});
  const StanceFinder finder(simple_rover());
  std::vector<Disc2> wall;
  for (double y_m = -30; y_m <= 30; y_m += 0.5) wall.push_back({{50.5, y_m}, 0.4});
  GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-20, -40}, {120, 40},
                0.5);
  RouteCost costs(map, finder, RouteAim::energy, wall);
  const Vec2 goal_m(100, 0);
  GroundMap coarser_map = map.coarser(4);
  RouteCost coarser = costs.over(coarser_map);
  ASSERT_LT(search_grid(coarser, {0, 0}, goal_m).cost, 1.01 * 100 * 1000) << "it is not shown";
  const GridRoute route = search_grid(costs, {0, 0}, goal_m);
  ASSERT_FALSE(route.line.empty());
  EXPECT_NEAR(route.cost, dijkstra_cost(costs, goal_m), 1e-6 * route.cost);
  EXPECT_GT(route.cost, 1.1 * 100 * 1000);
}

TEST(PlanLeg, goes_around_what_is_too_steep_and_costs_less_than_the_grid) {
  const Site site(rough());
  const DriveCost cost = simple_rover();
  for (const RouteAim aim : {RouteAim::energy, RouteAim::risk}) {
    const PlannedLeg leg = plan_leg(site.ground(), cost, {{0, 0, 0}, {100, 0, 0}, aim, 5});
    ASSERT_TRUE(leg.is_found()) << leg.reason;
    EXPECT_LT(leg.slope_max_rad, cost.limits.slope_max_rad);
    EXPECT_GT(leg.length_m, 100);
    EXPECT_LT(leg.length_m, 125);
    EXPECT_NEAR(leg.path_S_m.front().norm(), 0, 0.1);
    EXPECT_NEAR((leg.path_S_m.back() - Vec3(100, 0, 0)).norm(), 0, 0.1);
    // The walls of the first crater, 24 m wide at (30, 4), are avoided.
    for (std::size_t k = 0; k + 1 < leg.path_S_m.size(); ++k) {
      for (double share = 0; share <= 1; share += 0.01) {
        const Vec3 p_m = leg.path_S_m[k] + share * (leg.path_S_m[k + 1] - leg.path_S_m[k]);
        EXPECT_GT((p_m - Vec3(30, 4, 0)).head<2>().norm(), 10);
      }
    }
    const StanceFinder finder(cost);
    GroundMap map(site.ground(), MapFrame(site.ground().site(), {0, 0, 0}), {-40, -40}, {140, 40},
                  map_spacing_m(cost));
    RouteCost costs(map, finder, aim);
    EXPECT_LT(leg.cost, search_grid(costs, {0, 0}, {100, 0}).cost);
  }
}

// On level ground the straight line is the best route, at 1000 J/m.
TEST(PlanLeg, over_level_ground_is_straight) {
  const Site site({});
  LegRequest request{{0, 0, 0}, {60, 35, 0}, RouteAim::energy, 1};
  request.start_heading_rad = std::atan2(60, 35);
  const PlannedLeg leg = plan_leg(site.ground(), simple_rover(), request);
  ASSERT_EQ(leg.path_S_m.size(), 2u);
  EXPECT_NEAR(leg.length_m, std::hypot(60, 35), 1e-3);
  EXPECT_NEAR(leg.energy_j, 1000 * std::hypot(60, 35), 30);
  EXPECT_NEAR(leg.duration_s, leg.length_m, 1e-6);
}

// A rover of 1 t at 1 m/s loses half of its kinetic energy to the brakes.
TEST(PlanLeg, from_rest_tells_what_setting_off_takes) {
  const Site site({});
  DriveCost cost = simple_rover();
  cost.stop_j = 250;
  cost.stop_s = 4;
  LegRequest request{{0, 0, 0}, {60, 35, 0}, RouteAim::energy, 1};
  request.start_heading_rad = std::atan2(60, 35);
  const PlannedLeg rolling = plan_leg(site.ground(), cost, request);
  request.starts_at_rest = true;
  const PlannedLeg leg = plan_leg(site.ground(), cost, request);
  EXPECT_EQ(leg.path_S_m, rolling.path_S_m);
  EXPECT_DOUBLE_EQ(leg.energy_j, rolling.energy_j + 250);
  EXPECT_DOUBLE_EQ(leg.duration_s, rolling.duration_s + 4);
  // It turns by 180 degrees first, at half a radian a second, with wheels that steer there and
  // back.
  cost.turn_sprad = 2;
  cost.steer_s = 3;
  request.start_heading_rad -= 180 * deg;
  const PlannedLeg turned = plan_leg(site.ground(), cost, request);
  EXPECT_EQ(turned.path_S_m, rolling.path_S_m);
  EXPECT_NEAR(turned.duration_s, leg.duration_s + 2 * std::numbers::pi + 3, 1e-6);
}

TEST(PlanLeg, ends_at_its_goal_however_far_and_deep) {
  // On a descent of 10 degrees, distant places lie far below the plane of the map.
  const SiteFrame site(*find_body("Moon"), geodetic_from_degrees(30, 10));
  TerrainSpec spec;
  spec.layers = {PlaneSurface{0, 10 * deg, std::numbers::pi / 2}};
  const Ground ground(spec, site, 1);
  const Vec3 on_plane_m(2000, 0, 0);
  Ground::Probe probe(ground);
  const GroundSample below = probe.sample(on_plane_m);
  const Vec3 goal_m = on_plane_m - below.gap_m * below.up_S;
  const PlannedLeg leg = plan_leg(ground, simple_rover(), {{0, 0, 0}, goal_m, RouteAim::energy, 1});
  ASSERT_TRUE(leg.is_found()) << leg.reason;
  EXPECT_EQ(leg.path_S_m.back(), goal_m);
  EXPECT_NEAR((leg.path_S_m[leg.path_S_m.size() - 2] - goal_m).normalized().dot(Vec3::UnitY()), 0,
              1e-3);
}

TEST(PlanLeg, to_where_it_stands_keeps_its_heading) {
  const Site site({});
  DriveCost cost = simple_rover();
  cost.can_turn_on_spot = false;
  cost.turning_radius_min_m = 4;
  LegRequest request{{0, 0, 0}, {0, 0, 0}, RouteAim::energy, 1};
  request.start_heading_rad = 1.2;
  const PlannedLeg leg = plan_leg(site.ground(), cost, request);
  ASSERT_TRUE(leg.is_found()) << leg.reason;
  EXPECT_NEAR(leg.length_m, 0, 1e-6);
  EXPECT_EQ(leg.end_heading_rad, 1.2);
}

TEST(PlanLeg, that_is_too_long_or_for_wheels_that_do_not_drive_says_so) {
  const Site site({});
  const PlannedLeg far =
      plan_leg(site.ground(), simple_rover(), {{0, 0, 0}, {60000, 0, 0}, RouteAim::energy, 1});
  double longest_km = 0, spacing_m = 0;
  ASSERT_EQ(std::sscanf(far.reason.c_str(),
                        "it is 60.0 km long; %lf km at most can be planned at once in this "
                        "direction, at %lf m",
                        &longest_km, &spacing_m),
            2)
      << far.reason;
  // To the east the map measures 1.5 by 0.5 leg lengths, and may have 60 million cells.
  EXPECT_NEAR(longest_km, spacing_m * std::sqrt(6e7 / 0.75) / 1000, 0.1);
  DriveCost dead = simple_rover();
  for (SoilDrive& soil : dead.soils) soil.by_slope.clear();
  const PlannedLeg none =
      plan_leg(site.ground(), dead, {{0, 0, 0}, {20, 0, 0}, RouteAim::energy, 1});
  EXPECT_THAT(none.reason, HasSubstr("on soil that its wheels do not drive on"));
}

TEST(PlanLeg, is_the_same_whatever_was_planned_before) {
  const Site site(rough());
  const DriveCost cost = simple_rover();
  const LegRequest request{{0, 0, 0}, {100, 0, 0}, RouteAim::risk, 5};
  const PlannedLeg first = plan_leg(site.ground(), cost, request);
  plan_leg(site.ground(), cost, {{0, 0, 0}, {70, 30, 0}, RouteAim::energy, 9});
  const PlannedLeg again = plan_leg(site.ground(), cost, request);
  ASSERT_EQ(first.path_S_m.size(), again.path_S_m.size());
  for (std::size_t k = 0; k < first.path_S_m.size(); ++k) {
    EXPECT_EQ(first.path_S_m[k], again.path_S_m[k]);
  }
  EXPECT_EQ(first.cost, again.cost);
}

TEST(PlanLeg, says_why_there_is_no_route_and_how_near_one_comes) {
  // A ring-shaped wall, too steep to drive, around a level floor.
  const Site site({{60, 0, 40, 14, 2}});
  const DriveCost cost = simple_rover();
  const auto plan = [&](const Vec3& from_m, const Vec3& to_m) {
    return plan_leg(site.ground(), cost, {from_m, to_m, RouteAim::risk, 1});
  };
  const PlannedLeg inside = plan({0, 0, 0}, {60, 0, 0});
  EXPECT_FALSE(inside.is_found());
  EXPECT_THAT(inside.reason, HasSubstr("m; ahead the ground is on a slope of "));
  EXPECT_THAT(inside.reason, HasSubstr("20 are allowed"));
  EXPECT_GT((inside.nearest_S_m - Vec3(60, 0, 0)).norm(), 10);
  EXPECT_TRUE(plan({0, 0, 0}, inside.nearest_S_m).is_found());
  EXPECT_THAT(plan({0, 0, 0}, {46, 0, 0}).reason, HasSubstr("the goal is on a slope of "));
}

// Craters too steep to drive through stand side by side across all of the first corridor.
TEST(PlanLeg, goes_around_a_wall_that_is_wider_than_its_corridor) {
  std::vector<Form> wall;
  for (double y_m = -27; y_m <= 27; y_m += 6) wall.push_back({20, y_m, 10, 4, 0.5});
  const Site site(wall);
  for (const bool can_turn_on_spot : {true, false}) {
    DriveCost cost = simple_rover();
    cost.can_turn_on_spot = can_turn_on_spot;
    cost.turning_radius_min_m = 3;
    LegRequest request{{0, 0, 0}, {40, 0, 0}, RouteAim::energy, 1};
    request.start_heading_rad = 90 * deg;
    const PlannedLeg leg = plan_leg(site.ground(), cost, request);
    ASSERT_TRUE(leg.is_found()) << leg.reason;
    EXPECT_GT(leg.length_m, 2 * std::hypot(20, 32));
  }
}

TEST(PlanLeg, leaves_a_start_that_is_steeper_than_its_limit) {
  // A bowl whose wall is some 25 degrees steep there and falls to a level floor.
  const Site site({{60, 0, 40, 7, 0.5}});
  const DriveCost cost = simple_rover();
  const auto plan = [&](const Vec3& from_m, const Vec3& to_m) {
    return plan_leg(site.ground(), cost, {from_m, to_m, RouteAim::energy, 1});
  };
  const PlannedLeg down = plan({53, 0, 0}, {60, 0, 0});
  EXPECT_TRUE(down.is_found()) << down.reason;
  // Uphill it gets steeper.
  EXPECT_FALSE(plan({53, 0, 0}, {0, 0, 0}).is_found());
}

// A place close ahead of a rover that cannot turn on the spot is passed beside, not driven over.
TEST(PlanLeg, passes_what_it_was_stuck_at_in_its_tightest_turn) {
  const Site site({});
  DriveCost cost = simple_rover();
  cost.can_turn_on_spot = false;
  cost.turning_radius_min_m = 3.1;
  LegRequest request{{0, 0, 0}, {40, 0, 0}, RouteAim::energy, 1};
  request.start_heading_rad = 90 * deg;
  request.avoided = {{{3.9, 0, 0}, 3.1}};
  const PlannedLeg leg = plan_leg(site.ground(), cost, request);
  ASSERT_TRUE(leg.is_found()) << leg.reason;
  double nearest_m = 100;
  for (std::size_t k = 0; k + 1 < leg.path_S_m.size(); ++k) {
    for (double share = 0; share <= 1; share += 0.05) {
      const Vec3 p_m = leg.path_S_m[k] + share * (leg.path_S_m[k + 1] - leg.path_S_m[k]);
      nearest_m = std::min(nearest_m, (p_m - Vec3(3.9, 0, 0)).head<2>().norm());
    }
  }
  EXPECT_GT(nearest_m, 1.3);
}

}  // namespace
}  // namespace lsos::test
