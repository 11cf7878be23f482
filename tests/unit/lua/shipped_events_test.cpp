// events/Route.lua, Wait.lua and Pause.lua with a rover that only records commands.
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;

class ShippedEvents : public ::testing::Test {
 protected:
  PhaseAnswer run(const std::string& phase) { return host.run_phase(instance, phase, context); }

  Catalog catalog{std::vector<ScriptFolder>{{LSOS_SOURCE_DIR, ""}}};
  LuaHost host{catalog};
  RecordingRover rover;
  PhaseContext context{rover, {}, {}, {}, {}, 0, "A", 1, "leg 1"};
  ScriptInstance instance = 0;
};

TEST_F(ShippedEvents, all_scripts_load_without_a_warning) {
  std::string text;
  for (const Fault& fault : catalog.faults().sorted()) text += to_string(fault) + "\n";
  EXPECT_EQ(text, "");
}

TEST_F(ShippedEvents, route_follows_its_line_and_brakes_at_the_end) {
  EventArguments arguments;
  arguments.params = {{"speed_mps", 2.0}, {"arrival_radius_m", 1.5}};
  arguments.geometry_S_m = {Vec3(0, 0, 0), Vec3(10, 0, 0)};
  instance = host.begin("Route", arguments);
  EXPECT_EQ(std::get<GoTo>(run("start")).phase, "drive");
  EXPECT_EQ(rover.path, arguments.geometry_S_m);
  EXPECT_EQ(rover.settings.speed_mps, 2.0);
  EXPECT_EQ(rover.settings.arrival_radius_m, 1.5);
  rover.driving.status = DriveState::Status::driving;
  EXPECT_TRUE(std::holds_alternative<Arrival>(run("drive")));
  rover.driving.status = DriveState::Status::arrived;
  EXPECT_EQ(std::get<GoTo>(run("drive")).phase, "stop");
  EXPECT_TRUE(std::holds_alternative<Done>(run("stop")));
  EXPECT_THAT(rover.calls, ElementsAre("follow 2 points", "brake"));
}

TEST_F(ShippedEvents, route_leaves_the_speed_to_the_rover_when_the_plan_gives_none) {
  EventArguments arguments;
  arguments.params = {{"arrival_radius_m", 1.0}};
  arguments.geometry_S_m = {Vec3(10, 0, 0)};
  instance = host.begin("Route", arguments);
  run("start");
  EXPECT_EQ(rover.settings.speed_mps, std::nullopt);
}

TEST_F(ShippedEvents, route_fails_with_the_reason_of_the_drive) {
  EventArguments arguments;
  arguments.params = {{"arrival_radius_m", 1.0}};
  arguments.geometry_S_m = {Vec3(10, 0, 0)};
  instance = host.begin("Route", arguments);
  run("start");
  rover.driving.status = DriveState::Status::failed;
  rover.driving.reason = "stuck: slip 100 %";
  EXPECT_EQ(std::get<Fail>(run("drive")).reason, "stuck: slip 100 %");
}

class PathPlanRoute : public ShippedEvents {
 protected:
  PathPlanRoute() {
    arguments.params = {{"arrival_radius_m", 1.5},
                        {"aim", std::string("risk")},
                        {"slope_max_rad", 0.25},
                        {"stray_max_m", 4.0},
                        {"replans", std::int64_t{1}}};
    arguments.geometry_S_m = {Vec3(10, 0, 0), Vec3(20, 0, 0), Vec3(30, 0, 0)};
    rover.planned.path_S_m = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(20, 1, 0), Vec3(30, 0, 0)};
    rover.planned.legs = {
        {1, 1, 10, 10, 1e4, 0.1}, {2, 2, 10, 10, 1e4, 0.1}, {3, 3, 10, 10, 1e4, 0.2}};
    rover.rover.length_m = 4;
    instance = host.begin("PathPlanRoute", arguments);
  }

  // Lets the drive fail on the leg to a point of the path; the first point is 0.
  void fail_drive(bool is_blocked, std::size_t next_point) {
    rover.driving.status = DriveState::Status::failed;
    rover.driving.reason = "stuck";
    rover.driving.is_blocked = is_blocked;
    rover.driving.next_point = next_point;
  }

  EventArguments arguments;
};

TEST_F(PathPlanRoute, follows_the_way_that_is_planned) {
  EXPECT_EQ(std::get<GoTo>(run("plan")).phase, "drive");
  EXPECT_EQ(rover.route.aim, RouteAim::risk);
  EXPECT_EQ(rover.route.slope_max_rad, 0.25);
  EXPECT_EQ(rover.route.arrival_radius_m, 1.5);
  EXPECT_EQ(rover.route.speed_mps, std::nullopt);
  EXPECT_EQ(rover.settings.cross_track_max_m, 4);
  rover.driving.status = DriveState::Status::driving;
  EXPECT_TRUE(std::holds_alternative<Arrival>(run("drive")));
  rover.driving.status = DriveState::Status::arrived;
  EXPECT_EQ(std::get<GoTo>(run("drive")).phase, "stop");
  EXPECT_THAT(rover.calls, ElementsAre("plan from 1 of 3", "follow 4 points"));
}

TEST_F(PathPlanRoute, backs_up_where_that_is_planned) {
  rover.planned.gear_changes = {0, 2};
  run("plan");
  EXPECT_THAT(rover.settings.gear_changes, ElementsAre(0u, 2u));
}

// The route planned ahead is used only if its settings equal those that the event later requests.
TEST_F(PathPlanRoute, asks_for_the_same_before_the_run) {
  run("plan");
  EXPECT_EQ(host.route_settings("PathPlanRoute", arguments, {}), rover.route);
  EXPECT_EQ(host.route_settings("Route", arguments, {}), std::nullopt);
}

TEST_F(PathPlanRoute, fails_with_the_reason_when_there_is_no_route) {
  rover.planned = {};
  rover.planned.reason = "the goal is on a slope of 31 degrees";
  EXPECT_EQ(std::get<Fail>(run("plan")).reason, "the goal is on a slope of 31 degrees");
}

TEST_F(PathPlanRoute, plans_anew_from_the_next_waypoint_around_what_blocks) {
  run("plan");
  fail_drive(true, 2);
  EXPECT_EQ(std::get<GoTo>(run("drive")).phase, "plan");
  run("plan");
  EXPECT_THAT(rover.calls, ElementsAre("plan from 1 of 3", "follow 4 points",
                                       R"(note replan {"attempt":1,"reason":"stuck","waypoint":2})",
                                       "brake", "plan from 2 of 3", "follow 4 points"));
  ASSERT_EQ(rover.route.avoided.size(), 1u);
  EXPECT_EQ(rover.route.avoided[0].center_S_m, Vec3(0, 5, 0));
  EXPECT_EQ(rover.route.avoided[0].radius_m, 4);
  // The route is planned again only as often as the plan allows.
  EXPECT_EQ(std::get<Fail>(run("drive")).reason, "stuck");
}

TEST_F(PathPlanRoute, that_is_stuck_while_it_backs_up_avoids_what_lies_behind) {
  run("plan");
  fail_drive(true, 2);
  rover.driving.is_backward = true;
  run("drive");
  run("plan");
  ASSERT_EQ(rover.route.avoided.size(), 1u);
  EXPECT_EQ(rover.route.avoided[0].center_S_m, Vec3(0, -5, 0));
}

TEST_F(PathPlanRoute, that_strays_avoids_nothing) {
  run("plan");
  fail_drive(false, 3);
  run("drive");
  run("plan");
  EXPECT_EQ(rover.calls[4], "plan from 3 of 3");
  EXPECT_TRUE(rover.route.avoided.empty());
}

TEST_F(ShippedEvents, wait_sleeps_until_its_moment) {
  EventArguments arguments;
  arguments.params = {{"until_s", Instant{1'000'000'000}}};
  context.mission_start = {400'000'000};
  instance = host.begin("Wait", arguments);
  EXPECT_EQ(std::get<SleepUntil>(run("wait")).time, from_seconds(600));
  context.now = from_seconds(600);
  EXPECT_TRUE(std::holds_alternative<Done>(run("wait")));
}

TEST_F(ShippedEvents, pause_sleeps_for_its_duration) {
  EventArguments arguments;
  arguments.params = {{"duration_s", 30.0}};
  context.now = context.phase_start = context.event_start = from_seconds(100);
  instance = host.begin("Pause", arguments);
  EXPECT_EQ(std::get<SleepUntil>(run("pause")).time, from_seconds(130));
  context.now = from_seconds(130);
  EXPECT_TRUE(std::holds_alternative<Done>(run("pause")));
}

TEST_F(ShippedEvents, declare_what_the_contract_says) {
  const EventDeclaration& route = catalog.declarations().events.at("Route");
  EXPECT_TRUE(route.drives);
  EXPECT_THAT(route.geometries, ElementsAre(GeometryKind::line, GeometryKind::point));
  ASSERT_EQ(route.fields.size(), 2u);
  EXPECT_EQ(route.fields[0].name, "ArrivalRadius");
  EXPECT_EQ(std::get<double>(*route.fields[0].default_value), 1.0);
  EXPECT_EQ(route.fields[1].key, "speed_mps");
  EXPECT_FALSE(route.fields[1].default_value);
  const EventDeclaration& wait = catalog.declarations().events.at("Wait");
  EXPECT_TRUE(wait.fields[0].is_required);
  EXPECT_EQ(wait.fields[0].kind, FieldKind::utc);
  EXPECT_THAT(wait.geometries, ElementsAre(GeometryKind::none, GeometryKind::point));
}

}  // namespace
}  // namespace lsos
