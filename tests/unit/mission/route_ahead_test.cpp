// Routes planned before the mission starts, and their use when it runs.
#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "mission/model/site.h"
#include "test_mission.h"

namespace lsos::test {
namespace {

using testing::HasSubstr;

// Makes level ground with a crater 24 m wide whose walls are too steep, `east_m` east of 0.1, 0.2
// rad.
void dig(Mission& mission, double east_m) {
  ReliefSurface relief;
  relief.lon_rad = 0.1;
  relief.lat_rad = 0.2;
  relief.spacing_m = 1;
  const Body& moon = *find_body("Moon");
  const Geodetic place = SiteFrame(moon, {0.1, 0.2, 0}).geodetic({east_m, 0, 0});
  relief.landforms.push_back({"crater", place.lon_rad, place.lat_rad, 24, 6, 0.5});
  mission.setup_.terrain.layers = {relief};
}

const std::vector<LegAhead>& legs(const Mission& mission) {
  return mission.simulation_->routes_ahead().front().legs;
}

TEST(RouteAhead, begins_each_event_where_the_last_one_ends) {
  Mission mission;
  mission.rover("A");
  mission.drive("Plan", 20);
  mission.drive("Drive", 30);
  mission.event("Hold", 1);
  mission.drive("Plan", 50);
  const std::vector<EventRow> events = mission.run();
  for (const EventRow& event : events) EXPECT_EQ(event.status, EventStatus::completed);
  ASSERT_EQ(legs(mission).size(), 2u);
  EXPECT_EQ(legs(mission)[0].sequence, 1);
  EXPECT_NEAR(legs(mission)[0].leg.length_m, 20, 0.1);
  EXPECT_EQ(legs(mission)[1].sequence, 4);
  EXPECT_NEAR(legs(mission)[1].leg.length_m, 20, 0.1);
  EXPECT_NEAR(legs(mission)[1].start.p_S_m.x(), 30, 0.1);
}

TEST(RouteAhead, goes_round_a_crater_that_the_straight_line_crosses) {
  Mission mission;
  dig(mission, 25);
  mission.rover("A");
  mission.drive("Plan", 50);
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::completed) << event.reason;
  EXPECT_GT(legs(mission)[0].leg.length_m, 52);
  Mission straight;
  dig(straight, 25);
  straight.rover("A");
  straight.drive("Drive", 50);
  EXPECT_EQ(straight.run()[0].status, EventStatus::failed);
}

TEST(RouteAhead, without_a_way_is_a_fault_of_the_plan) {
  Mission mission;
  dig(mission, 50);
  mission.rover("A");
  mission.drive("Plan", 40);
  const auto message = [&] {
    try {
      mission.run();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message(), HasSubstr("Plan 'Plan 1': the leg to waypoint 1: the goal is on a slope"));
  EXPECT_THAT(message(), HasSubstr("the nearest place that can be reached is "));
  // When the plan handles the failure, it is a warning.
  mission.setup_.plan.events[0].on_failure = OnFailure::skip;
  EXPECT_EQ(message(), "");
  const EventRow event = mission.simulation_->events()[0];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_THAT(event.reason, HasSubstr("the goal is on a slope"));
  ASSERT_EQ(mission.simulation_->advice().size(), 1u);
  EXPECT_EQ(mission.simulation_->advice()[0].severity, Severity::warning);
}

// The event fails before it drives, so the next begins where the rover stood.
TEST(RouteAhead, goes_on_from_where_an_event_without_a_way_leaves_the_rover) {
  Mission mission;
  dig(mission, 50);
  mission.rover("A");
  mission.drive("Plan", 40);
  mission.drive("Plan", 20);
  mission.setup_.plan.events[0].on_failure = OnFailure::skip;
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[1].status, EventStatus::completed) << events[1].reason;
  ASSERT_EQ(legs(mission).size(), 2u);
  EXPECT_EQ(legs(mission)[1].start.p_S_m.x(), 0);
  EXPECT_EQ(mission.simulation_->advice().size(), 1u);
}

// Waypoint 1 lies on the wall of a crater: near enough to it is where the wall begins, and the next
// leg begins there.
TEST(RouteAhead, ends_where_its_goal_can_be_reached_within_the_radius) {
  Mission mission;
  dig(mission, 50);
  const auto ground = ground_at(mission.setup_.terrain, *find_body("Moon"), {0.1, 0.2, 0}, 0);
  const VehicleConfig vehicle = test::rover(1.6);
  PlannedLegs planned(*ground, 1);
  RoverRoutes routes(vehicle, {}, 0, *ground, planned);
  const Vec3 goal_m(40, 0, 0);
  RouteSettings settings;
  const PlannedLeg none = routes.leg(settings, {{0, 0, 0}, 0}, goal_m);
  ASSERT_FALSE(none.is_found());
  const double missed_m = (none.nearest_S_m - goal_m).norm();
  settings.arrival_radius_m = missed_m - 0.01;
  EXPECT_FALSE(routes.leg(settings, {{0, 0, 0}, 0}, goal_m).is_found());
  settings.arrival_radius_m = missed_m + 0.01;
  const PlannedLeg near = routes.leg(settings, {{0, 0, 0}, 0}, goal_m);
  ASSERT_TRUE(near.ends_short());
  EXPECT_LT((near.path_S_m.back() - none.nearest_S_m).norm(), 0.01);
  const PlannedRoute way =
      routes.plan("A", SimTime{}, 3, {{0, 0, 0}, 0}, {goal_m, {0, 30, 0}}, 1, settings);
  ASSERT_TRUE(way.is_found()) << way.reason;
  EXPECT_THAT(routes.take_warnings(),
              testing::ElementsAre(HasSubstr("A: the leg to waypoint 1 ends ")));
  ASSERT_EQ(way.legs.size(), 2u);
  EXPECT_LT((way.path_S_m[way.legs[0].last_point] - none.nearest_S_m).norm(), 0.01);
}

// Boxes stand ahead of the rover and beside it, so that it backs up to a first waypoint; the second
// lies beyond the boxes.
TEST(RouteAhead, joins_legs_that_back_up) {
  Mission mission;
  const auto ground = ground_at(mission.setup_.terrain, *find_body("Moon"), {0.1, 0.2, 0}, 0);
  VehicleConfig vehicle = test::rover(1.6);
  vehicle.can_turn_on_spot = false;
  vehicle.turning_radius_min_m = 4;
  PlannedLegs planned(*ground, 1);
  planned.set_standing({{"Front", {6, 0, 0}, {1, 0, 0}, {1, 8}},
                        {"Left", {0, 5, 0}, {1, 0, 0}, {4.5, 1}},
                        {"Right", {0, -5, 0}, {1, 0, 0}, {4.5, 1}}});
  RoverRoutes routes(vehicle, {}, 0, *ground, planned);
  const double east_rad = std::numbers::pi / 2;
  const PlannedRoute way =
      routes.plan("A", SimTime{}, 3, {{0, 0, 0}, east_rad, true}, {{-7, 0, 0}, {40, 0, 0}}, 1, {});
  ASSERT_TRUE(way.is_found()) << way.reason;
  ASSERT_EQ(way.legs.size(), 2u);
  ASSERT_FALSE(way.gear_changes.empty());
  EXPECT_EQ(way.gear_changes.front(), 0u) << "it begins backwards";
  EXPECT_EQ(way.gear_changes.size() % 2, 0u) << "and ends forwards";
  // The line turns back where the gear changes, and nowhere else.
  for (std::size_t k = 1; k + 1 < way.path_S_m.size(); ++k) {
    const Vec3 in_m = way.path_S_m[k] - way.path_S_m[k - 1];
    const Vec3 out_m = way.path_S_m[k + 1] - way.path_S_m[k];
    EXPECT_EQ(in_m.dot(out_m) < 0, std::ranges::count(way.gear_changes, k) == 1) << k;
  }
}

// The goal lies on the floor of a crater, behind walls that the rover may drive down but not climb.
TEST(RouteAhead, does_not_end_short_where_no_way_leads_back) {
  Mission mission;
  ReliefSurface relief;
  relief.lon_rad = 0.1;
  relief.lat_rad = 0.2;
  relief.spacing_m = 1;
  const Body& moon = *find_body("Moon");
  const Geodetic place = SiteFrame(moon, {0.1, 0.2, 0}).geodetic({60, 0, 0});
  relief.landforms.push_back({"crater", place.lon_rad, place.lat_rad, 60, 12, 0.5});
  mission.setup_.terrain.layers = {relief};
  const auto ground = ground_at(mission.setup_.terrain, moon, {0.1, 0.2, 0}, 0);
  const VehicleConfig vehicle = test::rover(1.6);
  PlannedLegs planned(*ground, 1);
  RoverRoutes routes(vehicle, {}, 0, *ground, planned);
  RouteSettings settings;
  settings.arrival_radius_m = 100;
  int short_ends = 0;
  for (double east_m = 20; east_m <= 60; east_m += 4) {
    const PlannedLeg leg = routes.leg(settings, {{0, 0, 0}, 0}, {east_m, 0, 0});
    if (!leg.ends_short()) continue;
    ++short_ends;
    const LegStart there{leg.path_S_m.back(), leg.end_heading_rad, true};
    EXPECT_TRUE(routes.leg({}, there, {0, 0, 0}).is_found()) << east_m;
  }
  EXPECT_GT(short_ends, 0);
}

// Within 5 m of the expected start the route is driven as planned; farther away it is planned anew.
TEST(RouteAhead, is_taken_up_near_to_where_the_rover_was_expected) {
  const auto ground = ground_at(Mission().setup_.terrain, *find_body("Moon"), {0.1, 0.2, 0}, 0);
  const VehicleConfig vehicle = test::rover(1.6);
  PlannedLegs planned(*ground, 1);
  RoverRoutes routes(vehicle, {}, 0, *ground, planned);
  const Vec3 goal_m(60, 0, 0);
  const std::vector<LegAhead> ahead{
      {3, 1, {{0, 0, 0}, 0}, goal_m, {}, routes.leg({}, {{0, 0, 0}, 0}, goal_m)}};
  const auto plans_anew = [&](double off_m, std::int64_t sequence, const RouteSettings& settings) {
    RoverRoutes asked(vehicle, {}, 0, *ground, planned);
    asked.set_ahead(ahead);
    const PlannedRoute way =
        asked.plan("A", SimTime{}, sequence, {{0, off_m, 0}, 0}, {goal_m}, 1, settings);
    EXPECT_TRUE(way.is_found());
    return !asked.take_rows().empty();
  };
  EXPECT_FALSE(plans_anew(0, 3, {}));
  EXPECT_FALSE(plans_anew(4.9, 3, {}));
  EXPECT_TRUE(plans_anew(5.1, 3, {}));
  EXPECT_TRUE(plans_anew(0, 4, {})) << "of another event";
  RouteSettings careful;
  careful.aim = RouteAim::risk;
  EXPECT_TRUE(plans_anew(0, 3, careful));
  // A second request means that something went wrong: the route begins where the rover is.
  routes.set_ahead(ahead);
  for (const std::size_t planned_anew : {0, 1}) {
    routes.plan("A", SimTime{}, 3, {{0, 1, 0}, 0}, {goal_m}, 1, {});
    EXPECT_EQ(routes.take_rows().size(), planned_anew);
  }
}

TEST(RouteAhead, logs_each_leg_with_the_number_of_its_attempt) {
  const auto ground = ground_at(Mission().setup_.terrain, *find_body("Moon"), {0.1, 0.2, 0}, 0);
  const VehicleConfig vehicle = test::rover(1.6);
  PlannedLegs planned(*ground, 1);
  RoverRoutes routes(vehicle, {}, 0, *ground, planned);
  const Path3 waypoints{{0.4, 0, 0}, {30, 0, 0}, {30, 30, 0}};
  const SimTime now = milliseconds(4200);
  const PlannedRoute way = routes.plan("A", now, 2, {{0, 0, 0}, 0}, waypoints, 1, {});
  ASSERT_EQ(way.legs.size(), 2u) << "it stands on the first waypoint";
  EXPECT_EQ(way.legs[0].waypoint, 2);
  EXPECT_EQ(way.legs[1].last_point, way.path_S_m.size() - 1);
  EXPECT_NEAR((way.path_S_m[way.legs[0].last_point] - waypoints[1]).norm(), 0, 0.1);
  routes.plan("A", now, 2, {{10, 0, 0}, 0}, waypoints, 2, {});
  const std::vector<PlannedPathRow> rows = routes.take_rows();
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].leg, 2);
  EXPECT_EQ(rows[0].attempt, 0);
  EXPECT_EQ(rows[2].leg, 2);
  EXPECT_EQ(rows[2].attempt, 1);
  EXPECT_EQ(rows[0].time, now);
  EXPECT_NEAR(rows[1].length_m, 30, 0.1);
  EXPECT_GE(rows[1].line.size(), 2u);
}

}  // namespace
}  // namespace lsos::test
