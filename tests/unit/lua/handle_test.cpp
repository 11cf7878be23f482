// `ev`, `rover` and `rover.drive` as scripts see them.
#include <fmt/format.h>

#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

void expect_done(EventRun& run) { EXPECT_TRUE(std::holds_alternative<Done>(run.run())); }

TEST(Handle, rover_shows_every_quantity_of_its_view) {
  auto run = EventRun::of_phase(R"(
    assert(rover.id == 'A' and rover.type == 'SEV' and rover.position == lsos.vec3(1, 2, 3))
    local names = { 'lon_rad', 'lat_rad', 'elevation_m', 'heading_rad', 'pitch_rad', 'roll_rad',
      'speed_mps', 'distance_m', 'slope_rad', 'slip', 'sinkage_m', 'drive_w', 'drive_j',
      'cruise_speed_mps' }
    for i, name in ipairs(names) do assert(rover[name] == i, name) end
    assert(rover.is_parked == true)
    return lsos.done)");
  RoverView& view = run->rover.rover;
  view.id = "A";
  view.type = "SEV";
  view.p_S_m = {1, 2, 3};
  double value = 0;
  for (double* member :
       {&view.lon_rad, &view.lat_rad, &view.elevation_m, &view.heading_rad, &view.pitch_rad,
        &view.roll_rad, &view.speed_mps, &view.distance_m, &view.slope_rad, &view.slip,
        &view.sinkage_m, &view.drive_w, &view.drive_j, &view.cruise_speed_mps}) {
    *member = ++value;
  }
  view.is_parked = true;
  expect_done(*run);
}

TEST(Handle, quantity_that_is_not_modelled_is_nil) {
  expect_done(*EventRun::of_phase("assert(rover.slip == nil) return lsos.done"));
}

TEST(Handle, drive_tells_what_became_of_follow) {
  auto run = EventRun::of_phase(R"(
    assert(rover.drive.status == 'failed' and rover.drive.reason == 'stuck')
    assert(rover.drive.remaining_m == 12.5)
    return lsos.done)");
  run->rover.driving = {DriveState::Status::failed, "stuck", 12.5};
  expect_done(*run);
}

TEST(Handle, follow_takes_lists_points_and_settings) {
  auto run = EventRun::of_phase(R"(
    rover:follow({ lsos.vec3(1, 2), lsos.vec3(3, 4, 5) })
    rover:follow(lsos.vec3(6, 7, 8), { speed_mps = 2, arrival_radius_m = 3 })
    rover:brake()
    return lsos.done)");
  expect_done(*run);
  EXPECT_THAT(run->rover.calls, ElementsAre("follow 2 points", "follow 1 points", "brake"));
  EXPECT_EQ(run->rover.path, Path3({Vec3(6, 7, 8)}));
  EXPECT_EQ(run->rover.settings.speed_mps, 2.0);
  EXPECT_EQ(run->rover.settings.arrival_radius_m, 3.0);
}

TEST(Handle, a_call_plans_some_1000_km) {
  const auto error = [](int legs, int calls) {
    return EventRun::of_phase(
               fmt::format("local p = {{}} for i = 1, {} do p[i] = lsos.vec3(i % 2 * 3000, 0) "
                           "end for i = 1, {} do rover:plan_path(p) end return lsos.done",
                           legs, calls))
        ->error();
  };
  EXPECT_EQ(error(250, 1), "no error");
  EXPECT_THAT(error(400, 1),
              HasSubstr("events/Probe.lua:3: Probe 'probe 1' in phase go at 0 s: "
                        "rover:plan_path: a route of 1200 km is more than one call may "
                        "plan; plan it in parts"));
  EXPECT_EQ(error(1, 10), "no error");
  EXPECT_THAT(error(1, 50), HasSubstr("events/Probe.lua:3: "));
}

TEST(Handle, follow_refuses_what_is_no_path_and_unknown_settings) {
  const auto error = [](const std::string& text) { return EventRun::of_phase(text)->error(); };
  EXPECT_THAT(error("rover:follow(5)"),
              HasSubstr("rover:follow wants a list of vec3, found a number"));
  EXPECT_THAT(error("rover:follow {}"), HasSubstr("wants at least one waypoint"));
  EXPECT_THAT(error("rover:follow { lsos.vec3(1, 2, 0/0) }"),
              HasSubstr("waypoint 1 must be a vec3 of numbers, found a vec3 whose x, y, z are "
                        "not all finite numbers"));
  EXPECT_THAT(error("rover:follow(lsos.vec3(1, 2, 0/0))"),
              HasSubstr("list of vec3, found a vec3 whose x, y, z are not all finite numbers"));
  for (const std::string changes : {"{ 0 }", "{ 2 }", "{ 1, 1 }", "{ 1.5 }", "'1'"}) {
    EXPECT_THAT(
        error("rover:follow { lsos.vec3(1, 2), lsos.vec3(3, 4), gear_changes = " + changes + " }"),
        HasSubstr("rover:follow: gear_changes of the path must be a list of its points, "
                  "integers from 1 to 1, ascending"))
        << changes;
  }
  EXPECT_THAT(error("rover:follow(lsos.vec3(1, 2), { speed = 2 })"),
              HasSubstr("events/Probe.lua:3: Probe 'probe 1' in phase go at 0 s: rover:follow: "
                        "unknown key 'speed'; did you mean 'speed_mps'?"));
  EXPECT_THAT(error("rover:follow(lsos.vec3(1, 2), { speed_mps = -2 })"),
              HasSubstr("speed_mps = -2: must be more than 0 m/s"));
}

TEST(Handle, distance_is_straight) {
  auto run =
      EventRun::of_phase("assert(rover:distance_to_m(lsos.vec3(3, 4, 12)) == 13) return lsos.done");
  expect_done(*run);
}

TEST(Handle, unknown_field_is_an_error_with_the_nearest) {
  EXPECT_THAT(EventRun::of_phase("return rover.speed")->error(),
              HasSubstr("events/Probe.lua:3: Probe 'probe 1' in phase go at 0 s: rover has no "
                        "'speed'; did you mean 'speed_mps'?"));
  EXPECT_THAT(EventRun::of_phase("ev.sate = {}")->error(),
              HasSubstr("what an event remembers goes into ev.state"));
  EXPECT_THAT(EventRun::of_phase("rover.speed_mps = 3")->error(),
              HasSubstr("rover is read-only, 'speed_mps' cannot be assigned"));
}

TEST(Handle, method_called_with_a_dot_is_explained) {
  EXPECT_THAT(EventRun::of_phase("rover.follow({})")->error(),
              HasSubstr("a method of rover is called with a colon"));
}

TEST(Handle, kept_beyond_its_call_is_refused) {
  EventRun run(R"(
    local kept = { [true] = {} }
    local function go(ev, rover)
      if kept[true][1] then return lsos.fail('%s', kept[true][1].id) end
      kept[true][1] = rover
    end)",
               "phases = { go = go }");
  run.rover.rover.id = "A";
  EXPECT_THAT(run.error(), HasSubstr("it changed 'kept', a local of the file"));
  EXPECT_THAT(run.error(), HasSubstr("it changed 'kept', a local of the file")) << "as it was";
}

TEST(Handle, log_writes_sorted_json) {
  auto run = EventRun::of_phase(R"(
    ev:log('reached', { waypoint = 3, at = lsos.vec3(1, 2, 3), z = { b = true, a = 'x' }, n = 0/0 })
    ev:log('plain')
    print('speed', 2.5, {})
    return lsos.done)");
  expect_done(*run);
  EXPECT_THAT(
      run->rover.calls,
      ElementsAre(
          R"(note reached {"at":[1.0,2.0,3.0],"n":null,"waypoint":3,"z":{"a":"x","b":true}})",
          "note plain {}", R"(note print {"text":"speed\t2.5\ttable"})"));
}

TEST(Handle, log_refuses_what_has_no_json_form) {
  EXPECT_THAT(EventRun::of_phase("ev:log('x', { a = { f = print } })")->error(),
              HasSubstr("a.f: a function cannot be written to the log"));
  EXPECT_THAT(EventRun::of_phase("ev:log('x', { 1, 2 })")->error(), HasSubstr("fields have names"));
  EXPECT_THAT(EventRun::of_phase("local t = {} t.t = t ev:log('x', t)")->error(),
              HasSubstr("nested too deep"));
}

TEST(Handle, log_loses_no_key_no_byte_and_stays_json) {
  EXPECT_THAT(EventRun::of_phase("ev:log('x', { t = { 1, 2, 3, name = 'lost' } })")->error(),
              HasSubstr("t: a list with a key 'name' besides cannot be written to the log"));
  auto run = EventRun::of_phase(
      "ev:log('x', { t = 'a\\0b', u = '\\xFF', i = math.huge, n = -math.huge }) return lsos.done");
  expect_done(*run);
  EXPECT_THAT(
      run->rover.calls,
      ElementsAre("note x {\"i\":null,\"n\":null,\"t\":\"a\\u0000b\",\"u\":\"\xEF\xBF\xBD\"}"));
}

TEST(Handle, numbers_that_are_not_finite_are_refused) {
  const auto error = [](const std::string& text) { return EventRun::of_phase(text)->error(); };
  EXPECT_THAT(error("rover:work(math.huge)"), HasSubstr("a power of 0 W or more is wanted"));
  EXPECT_THAT(error("rover:use('x', math.huge)"), HasSubstr("an amount of 0 or more is wanted"));
  EXPECT_THAT(error("rover:ahead(0/0)"), HasSubstr("a number of metres is wanted"));
  EXPECT_THAT(error("lsos.random(-math.huge, math.huge)"), HasSubstr("both must be finite"));
}

TEST(Handle, answers_outside_a_phase_are_refused) {
  try {
    EventRun run("local x = lsos.random()", "phases = { go = function() return x end }");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("lsos.random works only while a phase of an event runs"));
  }
  EXPECT_THAT(EventRun::of_phase("lsos.wheel {}")->error(),
              HasSubstr("lsos.wheel works only while a script loads"));
}

}  // namespace
}  // namespace lsos
