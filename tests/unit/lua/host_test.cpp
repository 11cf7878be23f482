// Phases of event scripts, called as the engine calls them.
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Host, nothing_returned_means_stay) {
  EXPECT_TRUE(std::holds_alternative<Stay>(EventRun::of_phase("return")->run()));
}

TEST(Host, gives_each_answer_to_the_engine) {
  EventRun run(R"(
    local function go() return 'on' end
    local function on() return lsos.done end
    local function failing(ev) return lsos.fail('at %.1f of %s', 2.5, ev.label) end
    local function sleeping() return lsos.sleep(60) end
    local function dozing() return lsos.sleep_until(90) end
    local function waiting() return lsos.arrival end)",
               "phases = { go = go, on = on, failing = failing, sleeping = sleeping, "
               "dozing = dozing, waiting = waiting }");
  run.context.now = from_seconds(12.5);
  EXPECT_EQ(std::get<GoTo>(run.run("go")).phase, "on");
  EXPECT_TRUE(std::holds_alternative<Done>(run.run("on")));
  EXPECT_EQ(std::get<Fail>(run.run("failing")).reason, "at 2.5 of probe 1");
  EXPECT_EQ(std::get<SleepUntil>(run.run("sleeping")).time, from_seconds(72.5));
  EXPECT_EQ(std::get<SleepUntil>(run.run("dozing")).time, from_seconds(90));
  EXPECT_TRUE(std::holds_alternative<Arrival>(run.run("waiting")));
}

TEST(Host, names_known_phases_when_an_answer_is_no_phase) {
  EXPECT_THAT(
      EventRun::of_phase("return 'gone'")->error(),
      StartsWith("events/Probe.lua:2: Probe 'probe 1' in phase go at 0 s: there is no phase "
                 "'gone'; did you mean 'go'?; phases are go"));
}

TEST(Host, refuses_an_answer_of_another_type) {
  EXPECT_THAT(EventRun::of_phase("return 5")->error(), HasSubstr("not a number"));
  EXPECT_THAT(EventRun::of_phase("return lsos.done, 1")->error(), HasSubstr("one value, not 2"));
}

TEST(Host, error_names_file_line_event_phase_time_and_cause) {
  auto run = EventRun::of_phase("local goal\nreturn goal.x");
  run->context.now = from_seconds(812.4);
  run->context.place = {"plan.kml", 41};
  run->rover.rover.p_S_m = {12.25, 40.12, 1};
  run->rover.rover.heading_rad = radians(90);
  run->rover.rover.speed_mps = 1.5;
  EXPECT_THAT(run->error(),
              StartsWith("events/Probe.lua:4: Probe 'probe 1' in phase go at 812.4 s: attempt to "
                         "index a nil value (local 'goal')\n"
                         "  plan.kml:41: rover A: 12.2 m east, 40.1 m north of the site, heading "
                         "90.0 deg, 1.50 m/s, slope 0.0 deg, 0.0 m driven, no drive yet\n"
                         "stack traceback:\n"));
}

TEST(Host, error_goes_on_from_a_value_that_is_no_text) {
  EXPECT_THAT(EventRun::of_phase("error({})")->error(),
              HasSubstr("an error whose value is a table"));
}

TEST(Host, gives_the_event_what_it_was_given) {
  EventArguments arguments;
  arguments.params = {
      {"speed_mps", 1.5}, {"until_s", Instant{90'000'000}}, {"crew", std::int64_t{2}}};
  arguments.geometry_S_m = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  EventRun run(R"(
    local function go(ev)
      assert(ev.params.speed_mps == 1.5 and ev.params.until_s == 30 and ev.params.crew == 2)
      assert(ev.params.absent_m == nil)
      assert(#ev.geometry == 2 and ev.geometry[2] == lsos.vec3(4, 5, 6) and not ev.geometry[3])
      assert(ev.label == 'probe 1' and ev.sequence == 10)
      assert(ev.time_s == 20 and ev.elapsed_s == 15 and ev.phase_elapsed_s == 5)
      local seen = {}
      for key, value in pairs(ev.params) do seen[#seen + 1] = key .. '=' .. value end
      assert(table.concat(seen, ' ') == 'crew=2 speed_mps=1.5 until_s=30.0')
      return lsos.done
    end)",
               R"(geometry = 'line', phases = { go = go }, params = {
      speed_mps = lsos.number { kml = 'Speed', unit = 'm/s' },
      absent_m = lsos.number { kml = 'Absent', unit = 'm' },
      crew = lsos.integer { kml = 'Crew' },
      until_s = lsos.utc { kml = 'Until' } })",
               arguments);
  run.context.mission_start = {60'000'000};
  run.context.now = from_seconds(20);
  run.context.event_start = from_seconds(5);
  run.context.phase_start = from_seconds(15);
  EXPECT_TRUE(std::holds_alternative<Done>(run.run()));
}

TEST(Host, refuses_a_misspelt_parameter_and_writing_to_one) {
  const char* params =
      "phases = { go = go }, params = { speed_mps = lsos.number { kml = 'Speed', "
      "unit = 'm/s' } }";
  EXPECT_THAT(EventRun("local function go(ev) return ev.params.speed_mp end", params).error(),
              HasSubstr("Probe has no parameter 'speed_mp'; did you mean 'speed_mps'?"));
  EXPECT_THAT(EventRun("local function go(ev) ev.params.speed_mps = 1 end", params).error(),
              HasSubstr("ev.params is read-only"));
}

TEST(Host, waypoints_cannot_be_changed) {
  EventArguments arguments;
  arguments.geometry_S_m = {Vec3(1, 2, 3)};
  EXPECT_THAT(EventRun::of_phase("ev.geometry[1] = 2", arguments)->error(),
              HasSubstr("ev.geometry is read-only"));
  EXPECT_TRUE(std::holds_alternative<Done>(
      EventRun::of_phase("ev.geometry[1].x = 9 assert(ev.geometry[1].x == 1) return lsos.done",
                         arguments)
          ->run()));
}

// Variables that functions share would differ between a mission that continues and one that was
// loaded.
TEST(Host, refuses_what_a_phase_keeps_in_a_local_of_the_file) {
  EventRun run(R"(
    local limit, count, text, unknown = 3, 0, nil, 0 / 0
    local function add(by) count = count + by end
    local function go(ev)
      if ev.label == 'probe 1' then add(1) end
      return count < limit and 'go' or lsos.done
    end
    local function keeps(ev) text = text or ev.label end
    local function breaks() text = 'kept' error('broken') end
    local function stays() return text == nil and unknown ~= unknown and lsos.done end)",
               "phases = { go = go, keeps = keeps, breaks = breaks, stays = stays }, "
               "on_abort = function() add(1) end");
  EXPECT_THAT(run.error("go"),
              StartsWith("events/Probe.lua:5: Probe 'probe 1' in phase go at 0 s: it "
                         "changed 'count', a local of the file, which all events of "
                         "the type would share and no mission saves; keep what lasts "
                         "in ev.state"));
  EXPECT_THAT(run.error("keeps"), HasSubstr("it changed 'text', a local of the file"));
  EXPECT_THAT(run.error("breaks"), HasSubstr("broken"));
  EXPECT_TRUE(std::holds_alternative<Done>(run.run("stays"))) << "as it was";
}

TEST(Host, refuses_what_a_phase_keeps_in_a_table_of_the_file) {
  EventRun run(R"(
    local seen, here = { deep = { first = 1 } }, nil
    local counter = {}
    function counter.add(ev) counter[ev.label] = true end
    local function go(ev) seen.deep.second = 2 return lsos.done end
    local function removes() seen.deep.first = nil return lsos.done end
    local function replaces() seen = {} return lsos.done end
    local function adds(ev) counter.add(ev) return lsos.done end
    local function moves(_, rover) here = rover.position return lsos.done end
    local behind, mark = setmetatable({}, { __index = { n = 0 } }), { __index = { n = 0 } }
    local marked = setmetatable({}, mark)
    local function hides() setmetatable(behind, { __index = { n = behind.n + 1 } }) end
    local function grows() mark.__index.n = marked.n + 1 end
    local count
    do
      local calls = 0
      count = setmetatable({}, { __call = function() calls = calls + 1 return calls end })
    end
    local function calls() return count() and lsos.done end
    mark.__gc = function() while true do end end
    local function stays()
      local first, second = seen.deep.first, seen.deep.second
      return first == 1 and second == nil and counter['probe 1'] == nil and not here and
        behind.n + marked.n == 0 and lsos.done
    end)",
               "phases = { go = go, removes = removes, replaces = replaces, adds = adds, "
               "moves = moves, hides = hides, grows = grows, calls = calls, stays = stays }");
  for (const char* phase : {"go", "removes", "replaces"}) {
    EXPECT_THAT(run.error(phase), HasSubstr("it changed 'seen', a local of the file")) << phase;
  }
  EXPECT_THAT(run.error("adds"), HasSubstr("it changed 'counter', a local of the file"));
  EXPECT_THAT(run.error("moves"), HasSubstr("it changed 'here', a local of the file"));
  EXPECT_THAT(run.error("hides"), HasSubstr("it changed 'behind', a local of the file"));
  EXPECT_THAT(run.error("calls"), HasSubstr("it changed 'calls', a local of the file"));
  EXPECT_THAT(run.error("grows"), HasSubstr("it changed 'mark', a local of the file"));
  EXPECT_TRUE(std::holds_alternative<Done>(run.run("stays"))) << "as it was";
}

// Garbage of earlier calls must not count against a later call's budget, because a resumed mission
// does not have it.
TEST(Host, budgets_forget_earlier_calls) {
  EventRun run(R"(
    local defaults = { step = 1 }
    local function work()
      local sum = 0
      for _ = 1, 20000 do sum = sum + 1 end
      return sum
    end
    local function go() return setmetatable({}, { __index = defaults }).step + work() > 0 and 'go' end
    local function deep(ev)
      local function down(n) if n == 0 then return 0 end return 1 + down(n - 1) end
      if not ev.state.was_deep then
        ev.state.was_deep = down(1500) > 0
      else
        for _ = 1, 20 do work() end
      end
    end)",
               "phases = { go = go, deep = deep }");
  for (int k = 0; k < 3000; ++k) run.run("go");
  EXPECT_EQ(run.error("deep"), "no error");
  EXPECT_EQ(run.error("deep"), "no error");
}

TEST(Host, state_lasts_between_calls) {
  auto run = EventRun::of_phase(
      "ev.state.n = (ev.state.n or 0) + 1 if ev.state.n == 3 then return lsos.done end");
  EXPECT_TRUE(std::holds_alternative<Stay>(run->run()));
  EXPECT_TRUE(std::holds_alternative<Stay>(run->run()));
  EXPECT_TRUE(std::holds_alternative<Done>(run->run()));
}

TEST(Host, two_events_of_one_type_have_states_of_their_own) {
  auto run = EventRun::of_phase("ev.state.n = (ev.state.n or 0) + 1 return lsos.sleep(ev.state.n)");
  run->run();
  run->instance = run->host->begin("Probe", {});
  EXPECT_EQ(std::get<SleepUntil>(run->run()).time, from_seconds(1));
}

TEST(Host, calls_on_abort_if_there_is_one) {
  EventRun with("local function go() end",
                "phases = { go = go }, on_abort = function(_, rover) rover:brake() end");
  with.host->run_abort(with.instance, with.context);
  EXPECT_THAT(with.rover.calls, ElementsAre("brake"));
  auto without = EventRun::of_phase("return");
  without->host->run_abort(without->instance, without->context);
  EXPECT_TRUE(without->rover.calls.empty());
}

TEST(Host, error_in_on_abort_says_so) {
  EventRun run("local function go() end",
               "phases = { go = go }, on_abort = function() error('no way') end");
  try {
    run.host->run_abort(run.instance, run.context);
    FAIL() << "no error";
  } catch (const ScriptError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Probe 'probe 1' in on_abort at 0 s: no way"));
  }
}

TEST(Host, random_numbers_are_keyed_by_rover_and_sequence) {
  const auto first = [](std::uint64_t seed, std::int64_t sequence) {
    auto run = EventRun::of_phase("return lsos.fail('%.17g', lsos.random())");
    run->context.seed = seed;
    run->context.sequence = sequence;
    return std::get<Fail>(run->run()).reason;
  };
  EXPECT_EQ(first(1, 1), first(1, 1));
  EXPECT_NE(first(1, 1), first(1, 2));
  EXPECT_NE(first(1, 1), first(2, 1));
  RandomStream expected(1, "A", 1, "script 0");
  EXPECT_EQ(std::stod(first(1, 1)), expected.uniform());
}

TEST(Host, faults_of_ours_pass_through_scripts_unchanged) {
  class BrokenRover : public RecordingRover {
    void brake() override { throw InternalError("broken promise"); }
  } broken;
  auto run = EventRun::of_phase("pcall(rover.brake, rover) return lsos.done");
  PhaseContext context{broken, {}, {}, {}, {}, 0, "A", 1, "x"};
  EXPECT_THROW(run->host->run_phase(run->instance, "go", context), InternalError);
}

}  // namespace
}  // namespace lsos
