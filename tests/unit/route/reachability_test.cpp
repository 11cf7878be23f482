// Whether a route exists, known before it is searched.
#include "route/search/reachability.h"

#include <gtest/gtest.h>

#include "route/search/grid_search.h"
#include "test_rover.h"

namespace lsos::test {
namespace {

// A ring-shaped wall, too steep to drive, around a level floor 60 m to the east.
class Ring {
 public:
  Reachability reach(const Vec2& start_m, const Vec2& goal_m, double aside_m = 40) {
    GroundMap map = map_about(aside_m);
    RouteCost costs(map, finder_, RouteAim::energy);
    return find_reachability(costs, start_m, goal_m);
  }
  GroundMap map_about(double aside_m) {
    return {site_.ground(),
            MapFrame(site_.ground().site(), {0, 0, 0}),
            {-aside_m, -aside_m},
            {100 + aside_m, aside_m},
            0.5};
  }
  const StanceFinder& finder() const { return finder_; }

 private:
  Site site_{{{60, 0, 40, 14, 2}}};
  StanceFinder finder_{simple_rover()};
};

TEST(Reachability, tells_that_the_goal_is_shut_in_by_looking_at_little) {
  Ring ring;
  const Reachability reach = ring.reach({0, 0}, {60, 0});
  EXPECT_EQ(reach.answer, Reachability::Answer::goal_enclosed);
  EXPECT_FALSE(reach.is_at_border);
  // The floor and as many nodes around the start are expanded, then those nearest to the goal; not
  // the whole map, 240 x 160.
  const Reachability wider = ring.reach({0, 0}, {60, 0}, 200);
  EXPECT_EQ(wider.answer, Reachability::Answer::goal_enclosed);
  EXPECT_LT(wider.expanded, 200'000u) << "of 800 x 400 x 4 nodes";
  // The rim is at 20 m.
  EXPECT_GT((reach.nearest_m - Vec2(60, 0)).norm(), 10);
  EXPECT_LT((reach.nearest_m - Vec2(60, 0)).norm(), 30);
}

TEST(Reachability, tells_that_the_start_is_shut_in) {
  Ring ring;
  const Reachability reach = ring.reach({60, 0}, {0, 0});
  EXPECT_EQ(reach.answer, Reachability::Answer::start_enclosed);
  EXPECT_FALSE(reach.is_at_border);
  EXPECT_LT((reach.nearest_m - Vec2(60, 0)).norm(), 20);
}

TEST(Reachability, tells_that_a_wider_map_may_open_what_is_shut_in) {
  Ring ring;
  // The map holds what is nearer than 8 m; the ring's rim is 20 m from its middle.
  const Reachability reach = ring.reach({0, 0}, {100, 0}, 8);
  EXPECT_NE(reach.answer, Reachability::Answer::joined);
  EXPECT_TRUE(reach.is_at_border);
}

TEST(Reachability, finds_what_the_search_finds) {
  Ring ring;
  GroundMap map = ring.map_about(40);
  RouteCost costs(map, ring.finder(), RouteAim::energy);
  int joined = 0;
  for (double x_m = 5; x_m <= 125; x_m += 7.3) {
    for (const double y_m : {-22.0, 0.0, 13.7}) {
      const bool is_joined =
          find_reachability(costs, {0, 0}, {x_m, y_m}).answer == Reachability::Answer::joined;
      EXPECT_EQ(is_joined, !search_grid(costs, {0, 0}, {x_m, y_m}).line.empty())
          << x_m << ", " << y_m;
      joined += is_joined;
    }
  }
  EXPECT_GT(joined, 30);
}

}  // namespace
}  // namespace lsos::test
