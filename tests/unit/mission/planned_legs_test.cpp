// Legs are planned once, kept for the next run, and never taken for another.
#include "mission/routes/planned_legs.h"

#include <gmock/gmock.h>

#include "mission/routes/rover_routes.h"
#include "unit/route/test_rover.h"

namespace lsos::test {
namespace {

LegRequest request() {
  LegRequest request;
  request.goal_S_m = {60, 5, 0};
  return request;
}

std::vector<Form> crater() { return {{30, 4, 24, 5, 0.5}}; }

TEST(PlannedLegs, are_recalled_to_the_last_bit) {
  const Site site(crater());
  PlannedLegs first(site.ground(), 7);
  const PlannedLeg planned = first.leg(simple_rover(), request());
  ASSERT_TRUE(planned.is_found());
  PlannedLegs second(site.ground(), 7);
  second.recall(first.kept());
  const PlannedLeg& recalled = second.leg(simple_rover(), request());
  EXPECT_EQ(recalled.path_S_m, planned.path_S_m);
  EXPECT_EQ(recalled.cost, planned.cost);
  EXPECT_EQ(recalled.end_heading_rad, planned.end_heading_rad);
  EXPECT_EQ(second.kept(), "") << "it has planned though it knew";
}

TEST(PlannedLegs, that_are_too_long_name_no_nearest_place_as_none_was_looked_for) {
  const Site site({});
  PlannedLegs legs(site.ground(), 7);
  LegRequest far = request();
  far.goal_S_m = {60e3, 0, 0};
  const PlannedLeg& leg = legs.leg(simple_rover(), far);
  ASSERT_FALSE(leg.is_found());
  const std::string text =
      RoverRoutes::no_route_text(site.ground(), 2, far.start_S_m, far.goal_S_m, leg);
  EXPECT_THAT(text, ::testing::StartsWith("the leg to waypoint 2: it is 60.0 km long; "));
  EXPECT_THAT(text, ::testing::EndsWith(" m: waypoints between make shorter legs"));
}

TEST(PlannedLegs, are_kept_while_more_are_planned) {
  const Site site({});
  PlannedLegs first(site.ground(), 7);
  std::string kept;
  first.set_keeper([&](const std::string& bytes) { kept = bytes; });
  LegRequest near = request(), far = request();
  near.goal_S_m = {8, 0, 0};
  far.goal_S_m = {12, 0, 0};
  first.leg(simple_rover(), near);
  PlannedLegs after_one(site.ground(), 7);
  after_one.recall(kept);
  after_one.leg(simple_rover(), near);
  EXPECT_EQ(after_one.kept(), "");
  first.leg(simple_rover(), far);
  PlannedLegs after_both(site.ground(), 7);
  after_both.recall(kept);
  after_both.leg(simple_rover(), near);
  after_both.leg(simple_rover(), far);
  EXPECT_EQ(after_both.kept(), "");
}

TEST(PlannedLegs, of_a_way_that_does_not_exist_are_kept_too) {
  const Site site({{60, 0, 40, 14, 2}});
  PlannedLegs first(site.ground(), 7), second(site.ground(), 7);
  const std::string reason = first.leg(simple_rover(), request()).reason;
  second.recall(first.kept());
  EXPECT_EQ(second.leg(simple_rover(), request()).reason, reason);
  EXPECT_EQ(second.kept(), "");
}

// A leg depends on seed, ground, rover, places, aim, and what is avoided.
TEST(PlannedLegs, are_not_taken_for_another) {
  const Site site(crater()), other_site({{30, 4.01, 24, 5, 0.5}});
  PlannedLegs first(site.ground(), 7);
  first.leg(simple_rover(), request());
  const std::string kept = first.kept();
  const auto plans = [&](const Ground& ground, std::uint64_t seed, const DriveCost& cost,
                         const LegRequest& asked) {
    PlannedLegs legs(ground, seed);
    legs.recall(kept);
    legs.leg(cost, asked);
    return !legs.kept().empty();
  };
  EXPECT_FALSE(plans(site.ground(), 7, simple_rover(), request()));
  EXPECT_TRUE(plans(site.ground(), 8, simple_rover(), request()));
  EXPECT_TRUE(plans(other_site.ground(), 7, simple_rover(), request()));
  DriveCost weaker = simple_rover();
  weaker.soils[0].by_slope[3].energy_jpm += 1e-9;
  EXPECT_TRUE(plans(site.ground(), 7, weaker, request()));
  LegRequest asked = request();
  asked.aim = RouteAim::risk;
  EXPECT_TRUE(plans(site.ground(), 7, simple_rover(), asked));
  asked = request();
  asked.goal_S_m.x() += 1e-9;
  EXPECT_TRUE(plans(site.ground(), 7, simple_rover(), asked));
  asked = request();
  asked.avoided = {{{1, 2, 3}, 1}};
  EXPECT_TRUE(plans(site.ground(), 7, simple_rover(), asked));
}

TEST(PlannedLegs, that_are_damaged_are_planned_again) {
  const Site site(crater());
  PlannedLegs first(site.ground(), 7);
  const double cost = first.leg(simple_rover(), request()).cost;
  const std::string kept = first.kept();
  std::string flipped = kept;
  flipped[kept.size() / 2] ^= 1;
  for (const std::string& bytes :
       {std::string(), std::string("x"), flipped, kept.substr(0, kept.size() - 9), kept + "z"}) {
    PlannedLegs legs(site.ground(), 7);
    legs.recall(bytes);
    EXPECT_EQ(legs.leg(simple_rover(), request()).cost, cost);
    EXPECT_NE(legs.kept(), "");
  }
}

TEST(PlannedLegs, are_not_longer_than_any_that_is_planned) {
  PlannedLeg leg;
  leg.path_S_m = {{0, 0, 0}, {5e5, 0, 0}};
  EXPECT_TRUE(leg.is_sound());
  leg.path_S_m.push_back({0, 2e5, 0});
  EXPECT_FALSE(leg.is_sound());
}

}  // namespace
}  // namespace lsos::test
