// The cost to go, against the search that goes forwards.
#include "route/search/cost_to_go.h"

#include <gtest/gtest.h>

#include "route/search/grid_search.h"
#include "test_rover.h"

namespace lsos::test {
namespace {

class Plain {
 public:
  GroundMap map() const {
    return {
        site_.ground(), MapFrame(site_.ground().site(), {0, 0, 0}), {-100, -100}, {140, 100}, 1};
  }
  const StanceFinder& finder() const { return finder_; }

 private:
  Site site_{{{60, 0, 40, 14, 2}}};  // a crater that routes go round
  StanceFinder finder_{simple_rover()};
};

TEST(CostToGo, is_what_the_way_there_costs) {
  const Plain plain;
  GroundMap map = plain.map();
  RouteCost costs(map, plain.finder(), RouteAim::energy);
  const Vec2 start_m(0, 0), goal_m(100, 0);
  CostToGo to_go(costs, start_m, goal_m);
  // The least of four nodes is nearer by at most the diagonal of a cell, on the level.
  constexpr double cell_j = 1.5 * 1000;
  for (const Vec2& at_m : {start_m, Vec2(30, 20), Vec2(-20, -40), Vec2(80, 60), Vec2(99, 1)}) {
    const double whole = search_grid(costs, at_m, goal_m).cost;
    EXPECT_LE(to_go.at(at_m), whole * (1 + 1e-9)) << at_m.transpose();
    EXPECT_GT(to_go.at(at_m), whole - cell_j) << at_m.transpose();
  }
  EXPECT_FALSE(std::isfinite(to_go.at({60, 0}))) << "the crater's floor, shut in";
  EXPECT_FALSE(to_go.was_limited());
}

TEST(CostToGo, is_not_looked_for_beyond_its_limit) {
  const Plain plain;
  GroundMap map = plain.map();
  RouteCost costs(map, plain.finder(), RouteAim::energy);
  const Vec2 start_m(0, 0), goal_m(100, 0), behind_m(-60, 0);
  CostToGo to_go(costs, start_m, goal_m);
  const double least = to_go.at(start_m);
  to_go.set_limit(1.3 * least);
  EXPECT_FALSE(std::isfinite(to_go.at(behind_m)));
  EXPECT_TRUE(to_go.was_limited());
  EXPECT_TRUE(std::isfinite(to_go.at({50, 35}))) << "within it";
  EXPECT_LT(map.sampled_nodes(), 30'000u) << "of 48,000";
  to_go.set_limit(4 * least);
  EXPECT_TRUE(std::isfinite(to_go.at(behind_m))) << "there and back";
}

TEST(CostToGo, is_looked_for_only_within_a_tube) {
  const Plain plain;
  GroundMap map = plain.map();
  RouteCost costs(map, plain.finder(), RouteAim::energy);
  const Vec2 start_m(0, 0), goal_m(100, 0);
  const Corridor corridor(map, search_grid(costs, start_m, goal_m).line, 12);
  GroundMap fresh = plain.map();
  RouteCost fresh_costs(fresh, plain.finder(), RouteAim::energy);
  CostToGo within(fresh_costs, start_m, goal_m, &corridor), whole(costs, start_m, goal_m);
  constexpr double cell_j = 1.5 * 1000;  // the first known of four nodes
  EXPECT_NEAR(within.at(start_m), whole.at(start_m), cell_j) << "the cheapest way lies in it";
  EXPECT_FALSE(std::isfinite(within.at({50, -70})));
  EXPECT_FALSE(within.was_limited());
  EXPECT_TRUE(std::isfinite(whole.at({50, -70})));
  EXPECT_LT(fresh.sampled_nodes(), map.sampled_nodes() / 2);
}

}  // namespace
}  // namespace lsos::test
