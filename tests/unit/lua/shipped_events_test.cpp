// events/Route.lua, Wait.lua and Pause.lua against a rover that only remembers commands.
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
  rover.drive_state.status = DriveState::Status::driving;
  EXPECT_TRUE(std::holds_alternative<Arrival>(run("drive")));
  rover.drive_state.status = DriveState::Status::arrived;
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
  rover.drive_state = {DriveState::Status::failed, "stuck: slip 100 %", 3};
  EXPECT_EQ(std::get<Fail>(run("drive")).reason, "stuck: slip 100 %");
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
