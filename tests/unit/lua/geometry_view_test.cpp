// ev.geometry of a polygon: its holes, and paths within the polygon.
#include <fmt/format.h>

#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

// A polygon of 40 m by 20 m with a hole of 10 m by 10 m in its middle.
EventArguments area() {
  EventArguments arguments;
  arguments.geometry_S_m = {Vec3(0, 0, 0), Vec3(40, 0, 0), Vec3(40, 20, 0), Vec3(0, 20, 0)};
  arguments.holes_S_m = {{Vec3(15, 5, 0), Vec3(25, 5, 0), Vec3(25, 15, 0), Vec3(15, 15, 0)}};
  return arguments;
}

// The reason that a phase with this text gives to lsos.fail.
std::string fail_reason(const std::string& text, const EventArguments& arguments = area()) {
  return std::get<Fail>(EventRun::of_phase(text, arguments)->run()).reason;
}

TEST(Geometry, of_a_polygon_has_its_holes) {
  EXPECT_EQ(
      fail_reason("local h = ev.geometry.holes return lsos.fail('%d %d %g', #h, #h[1], h[1][3].x)"),
      "1 4 25");
  EXPECT_EQ(fail_reason("return lsos.fail('%d', #ev.geometry.holes)", {}), "0");
}

TEST(Geometry, cuts_a_line_at_the_margin_of_its_holes) {
  EXPECT_EQ(
      fail_reason("local p = ev.geometry:parts(lsos.vec3(-5, 10), lsos.vec3(50, 10), 2)\n"
                  "return lsos.fail('%d: %.9g to %.9g, %.9g to %.9g', #p, p[1][1].x, p[1][2].x, "
                  "p[2][1].x, p[2][2].x)"),
      "2: 0 to 13, 27 to 40");
}

TEST(Geometry, knows_a_path_round_its_holes) {
  EXPECT_EQ(
      fail_reason("local w, m = ev.geometry:path(lsos.vec3(5, 9), lsos.vec3(35, 9), 2)\n"
                  "return lsos.fail('%d: %g,%g %g,%g %g,%g by %g', #w, w[1].x, w[1].y, w[2].x, "
                  "w[2].y, w[3].x, w[3].y, m)"),
      "3: 13,3 27,3 35,9 by 2");
}

TEST(Geometry, says_why_there_is_no_path) {
  EXPECT_EQ(fail_reason("local way, why = ev.geometry:path(lsos.vec3(5, 9), lsos.vec3(20, 10))\n"
                        "return lsos.fail('%s: %s', way, why)"),
            "nil: there is no path within the polygon, round its holes");
  // A comb of bays 100 m long and 2 m wide.
  EventArguments comb;
  for (int tooth = 0; tooth < 2500; ++tooth) {
    const double x_m = 4.0 * tooth, end_m = tooth % 2 == 0 ? 0 : 2;
    for (const double y_m : {100.0, end_m}) comb.geometry_S_m.emplace_back(x_m, y_m, 0);
    for (const double y_m : {end_m, 100.0}) comb.geometry_S_m.emplace_back(x_m + 2, y_m, 0);
  }
  comb.geometry_S_m.emplace_back(10000, 100, 0);
  comb.geometry_S_m.emplace_back(10000, -50, 0);
  comb.geometry_S_m.emplace_back(-2, -50, 0);
  comb.geometry_S_m.emplace_back(-2, 100, 0);
  EXPECT_EQ(fail_reason("local way, why = ev.geometry:path(lsos.vec3(3, 90), lsos.vec3(9003, 90))\n"
                        "return lsos.fail('%s: %s', way, why)",
                        comb),
            "nil: the polygon has too many corners (10004) to find paths in; simplify it");
}

TEST(Geometry, says_what_is_no_polygon) {
  EXPECT_THAT(EventRun::of_phase("ev.geometry:path(lsos.vec3(0, 0), lsos.vec3(1, 0))")->error(),
              HasSubstr("ev.geometry:path is for polygons; this one has 0 waypoints"));
  EXPECT_THAT(EventRun::of_phase("return ev.geometry.hole", area())->error(),
              HasSubstr("beside that it has holes, parts and path"));
}

TEST(Warn, is_a_warning_of_the_run_and_a_note) {
  auto run = EventRun::of_phase("ev:warn('%d of %s', 3, 'x') return lsos.done");
  run->run();
  EXPECT_THAT(run->rover.calls, ::testing::ElementsAre(R"(note warning {"text":"3 of x"})",
                                                       "warn probe 1 of A: 3 of x"));
}

TEST(OnAbort, may_say_how_far_the_event_had_come) {
  const auto says = [](const std::string& body) {
    EventRun run("local function go() end",
                 "phases = { go = go }, on_abort = function(ev) " + body + " end");
    return run.host->run_abort(run.instance, run.context);
  };
  EXPECT_EQ(says("return ('%d of 3'):format(2)"), "2 of 3");
  EXPECT_EQ(says("return nil"), "");
  EXPECT_THROW(says("return 5"), ScriptError);
}

TEST(Check, knows_the_rover_and_may_warn) {
  EventRun run("local function go() end",
               "phases = { go = go }, check = function(_, rover) if not rover then return 'none' "
               "end return nil, ('%s %g %s'):format(rover.type, rover.battery_capacity_j, "
               "rover.panels[1].name) end");
  PlanRover rover;
  rover.type = "SEV";
  RoverModel model;
  model.power.battery.emplace().capacity_j = 5;
  model.power.panels.emplace_back().name = "Roof";
  EXPECT_EQ(run.host->check("Probe", {}, {}, &rover, &model).warning, "SEV 5 Roof");
  EXPECT_EQ(run.host->check("Probe", {}, {}, nullptr, nullptr).fault, "none");
}

TEST(OpenEnded, is_what_has_no_time_among_its_fields_unless_it_says_otherwise) {
  const auto is_open = [](const std::string& more) {
    EventRun run("local function go() end", "phases = { go = go }, " + more);
    return run.host->is_open_ended("Probe", {}, {});
  };
  EXPECT_TRUE(is_open(""));
  EXPECT_FALSE(is_open("drives = true"));
  EXPECT_FALSE(is_open("open_ended = false"));
  EXPECT_FALSE(is_open("params = { duration_s = lsos.duration { kml = 'Duration' } }"));
  EXPECT_TRUE(is_open("drives = true, open_ended = function() return true end"));
}

}  // namespace
}  // namespace lsos
