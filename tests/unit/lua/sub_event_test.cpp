// Phases that are another event.
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// A child event with a field of every kind.
constexpr const char* child = R"(
local lsos = require 'lsos'
return lsos.event {
  api = 1, doc = 'A child.', geometry = { 'none', 'point' },
  params = {
    speed_mps = lsos.number { kml = 'Speed', unit = 'm/s', min = 0.1, max = 5, default = 2 },
    crew = lsos.integer { kml = 'Crew', default = 1 },
    is_quick = lsos.boolean { kml = 'Quick', default = false },
    mode = lsos.choice { kml = 'Mode', choices = { 'track', 'fixed' }, default = 'track' },
    until_s = lsos.utc { kml = 'Until' },
    hold_s = lsos.duration { kml = 'Hold', required = true },
    remark = lsos.text { kml = 'Remark' },
  },
  phases = { go = function() end },
})";

// A parent event whose phase `go` is the child with these parameters.
class Parent {
 public:
  explicit Parent(const std::string& sub_event, const EventArguments& arguments = {}) {
    directory.write("events/Child.lua", child);
    directory.write(
        "events/Parent.lua",
        "local lsos = require 'lsos'\nreturn lsos.event { api = 1, doc = 'A parent.', "
        "geometry = { 'none', 'line' }, start = 'go', phases = { rest = function() end, "
        "go = lsos.sub_event { event = 'Child', " +
            sub_event + " } } }");
    catalog = std::make_unique<Catalog>(std::vector<ScriptFolder>{{directory.path(), ""}});
    EXPECT_EQ(errors_of(*catalog, ScriptKind::event, "Parent"), "");
    host = std::make_unique<LuaHost>(*catalog);
    instance = host->begin("Parent", arguments);
  }
  RunEvent run() { return std::get<RunEvent>(host->run_phase(instance, "go", context)); }
  std::string error() {
    try {
      run();
    } catch (const ScriptError& failure) {
      return failure.what();
    }
    return "no error";
  }

  ScriptDirectory directory;
  std::unique_ptr<Catalog> catalog;
  std::unique_ptr<LuaHost> host;
  RecordingRover rover;
  PhaseContext context{rover, from_seconds(5), {}, {}, {60'000'000}, 0, "A", 1, "both"};
  ScriptInstance instance = 0;
};

TEST(SubEvent, is_given_its_defaults) {
  const RunEvent answer = Parent("params = { hold_s = 3 }").run();
  EXPECT_EQ(answer.type, "Child");
  EXPECT_EQ(answer.next, "");
  const auto& params = answer.arguments.params;
  EXPECT_EQ(std::get<double>(params.at("hold_s")), 3);
  EXPECT_EQ(std::get<double>(params.at("speed_mps")), 2);
  EXPECT_EQ(std::get<std::int64_t>(params.at("crew")), 1);
  EXPECT_EQ(std::get<bool>(params.at("is_quick")), false);
  EXPECT_EQ(std::get<std::string>(params.at("mode")), "track");
  EXPECT_FALSE(params.contains("until_s"));
  EXPECT_FALSE(params.contains("remark"));
}

TEST(SubEvent, parameters_may_come_from_a_function_of_the_event) {
  Parent parent(R"(params = function(ev, rover) return {
      hold_s = ev.time_s + 1, until_s = 30, is_quick = true, mode = 'fixed', remark = rover.id,
      crew = 2 } end, next = 'rest')");
  parent.rover.rover.id = "A";
  const RunEvent answer = parent.run();
  const auto& params = answer.arguments.params;
  EXPECT_EQ(answer.next, "rest");
  EXPECT_EQ(std::get<double>(params.at("hold_s")), 6);
  EXPECT_EQ(std::get<Instant>(params.at("until_s")), Instant{90'000'000});
  EXPECT_EQ(std::get<bool>(params.at("is_quick")), true);
  EXPECT_EQ(std::get<std::string>(params.at("mode")), "fixed");
  EXPECT_EQ(std::get<std::string>(params.at("remark")), "A");
  EXPECT_EQ(std::get<std::int64_t>(params.at("crew")), 2);
}

TEST(SubEvent, every_wrong_parameter_is_named_at_once) {
  const std::string text =
      Parent("params = { speed_mps = 9, crew = 1.5, mode = 'trak', hold = 1 }").error();
  EXPECT_THAT(text, StartsWith("events/Parent.lua:2: Parent 'both' in phase go at 5 s: parameters "
                               "of Child: "));
  EXPECT_THAT(text, HasSubstr("speed_mps = 9: must be 0.1..5 m/s"));
  EXPECT_THAT(text, HasSubstr("crew = 1.5: must be a whole number"));
  EXPECT_THAT(text, HasSubstr("mode = 'trak': must be one of track, fixed; did you mean 'track'?"));
  EXPECT_THAT(text, HasSubstr("unknown key 'hold'; did you mean 'hold_s'?"));
  EXPECT_THAT(text, HasSubstr("'hold_s' is missing"));
}

TEST(SubEvent, parameters_must_be_a_table) {
  EXPECT_THAT(Parent("params = function() return 5 end").error(),
              HasSubstr("parameters of Child must be a table, found a number"));
}

TEST(SubEvent, takes_a_point_or_a_path) {
  EventArguments arguments;
  arguments.geometry_S_m = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  const std::string params = "params = { hold_s = 1 }, geometry = ";
  EXPECT_EQ(Parent(params + "function(ev) return ev.geometry[2] end", arguments)
                .run()
                .arguments.geometry_S_m,
            Path3({Vec3(4, 5, 6)}));
  EXPECT_EQ(
      Parent(params + "function() return { lsos.vec3(7, 8, 9) } end").run().arguments.geometry_S_m,
      Path3({Vec3(7, 8, 9)}));
  EXPECT_THAT(Parent(params + "function(ev) return ev.geometry end", arguments).error(),
              HasSubstr("Child does not take a geometry of 2 waypoints"));
  EXPECT_THAT(Parent(params + "function() return { 5 } end").error(),
              HasSubstr("the geometry of Child: waypoint 1 must be a vec3 of numbers"));
}

TEST(SubEvent, error_in_its_function_names_the_parent) {
  EXPECT_THAT(Parent("params = function() error('no') end").error(),
              HasSubstr("events/Parent.lua:2: Parent 'both' in phase go at 5 s: no"));
}

}  // namespace
}  // namespace lsos
