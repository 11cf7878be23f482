// ev.state survives save and restore.
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

TEST(State, comes_back_as_it_was) {
  EventRun run(R"(
    local function go(ev)
      ev.state = { yes = true, no = false, whole = 7, big = math.mininteger, float = 0.1,
                   tiny = 5e-324, inf = math.huge, zero = -0.0, text = 'a\0b', list = { 1, 'x', { 2 } },
                   point = lsos.vec3(1, 2, 3), nested = { deep = { deeper = 'end' } }, empty = {} }
    end
    local function check(ev)
      local s = ev.state
      assert(s.yes == true and s.no == false and math.type(s.whole) == 'integer' and s.whole == 7)
      assert(s.big == math.mininteger and s.float == 0.1 and s.tiny == 5e-324 and s.inf == math.huge)
      assert(1 / s.zero == -math.huge and s.text == 'a\0b' and #s.list == 3 and s.list[3][1] == 2)
      assert(s.point + s.point == lsos.vec3(2, 4, 6) and s.nested.deep.deeper == 'end')
      assert(lsos.is_empty(s.empty))
      return lsos.done
    end)",
               "phases = { go = go, check = check }");
  run.run();
  run.recreate();
  EXPECT_TRUE(std::holds_alternative<Done>(run.run("check")));
}

TEST(State, bytes_do_not_depend_on_the_order_of_assignment) {
  auto a = EventRun::of_phase("ev.state.x = 1 ev.state.y = 2 ev.state.z = 3");
  auto b = EventRun::of_phase("ev.state.z = 3 ev.state.y = 2 ev.state.x = 1");
  a->run();
  b->run();
  EXPECT_EQ(a->host->save(a->instance), b->host->save(b->instance));
}

TEST(State, random_numbers_go_on_after_a_restore) {
  const char* phase = "return lsos.sleep(math.floor(1e6 * lsos.random()))";
  auto straight = EventRun::of_phase(phase), torn = EventRun::of_phase(phase);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(std::get<SleepUntil>(straight->run()).time, std::get<SleepUntil>(torn->run()).time);
    torn->recreate();
  }
}

TEST(State, what_cannot_be_saved_is_refused_with_its_path_in_the_phase_that_put_it) {
  const auto error = [](const std::string& text) { return EventRun::of_phase(text)->error(); };
  EXPECT_THAT(error("ev.state.path = { {}, {}, { f = print } }"),
              HasSubstr("events/Probe.lua:2: Probe 'probe 1' in phase go at 0 s: "
                        "ev.state.path[3].f: a function cannot be saved"));
  EXPECT_THAT(error("ev.state.rover = rover"), HasSubstr("ev.state.rover: an object of the host"));
  EXPECT_THAT(error("ev.state.answer = lsos.done"), HasSubstr("ev.state.answer: an answer"));
  EXPECT_THAT(error("ev.state.t = setmetatable({}, {})"),
              HasSubstr("ev.state.t: a table with a metatable cannot be saved"));
  EXPECT_THAT(error("ev.state.t = { 1, nil, 3 }"), HasSubstr("ev.state.t[2] is a hole"));
  EXPECT_THAT(error("ev.state.t = { [5] = 1 }"), HasSubstr("ev.state.t[5]: a list begins at 1"));
  EXPECT_THAT(error("ev.state.t = { [true] = 1 }"), HasSubstr("ev.state.t: a boolean as a key"));
  EXPECT_THAT(error("ev.state.t = { [1.5] = 1 }"), HasSubstr("ev.state.t: a number as a key"));
  EXPECT_THAT(error("local v = lsos.vec3(1, 2, 3) v.x = 'one' ev.state.v = v"),
              HasSubstr("ev.state.v: x, y, z must be finite numbers"));
}

TEST(State, cycles_and_shared_tables_are_refused_naming_both_paths) {
  EXPECT_THAT(EventRun::of_phase("ev.state.me = ev.state")->error(),
              HasSubstr("ev.state.me is the same table as ev.state"));
  EXPECT_THAT(EventRun::of_phase("local t = {} ev.state.a = t ev.state.b = { t }")->error(),
              HasSubstr("ev.state.b[1] is the same table as ev.state.a"));
}

TEST(State, too_deep_nesting_is_refused) {
  EXPECT_THAT(
      EventRun::of_phase("local t = ev.state for i = 1, 200 do t.t = {} t = t.t end")->error(),
      HasSubstr("nested deeper than 100"));
}

TEST(State, must_be_a_table) {
  EXPECT_THAT(EventRun::of_phase("ev.state = 5")->error(), HasSubstr("ev.state must be a table"));
}

TEST(State, damaged_bytes_are_refused) {
  auto run = EventRun::of_phase("ev.state.x = 1");
  run->run();
  const std::string bytes = run->host->save(run->instance);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const ScriptInstance instance = run->host->begin("Probe", {});
    EXPECT_THROW(run->host->restore(instance, bytes.substr(0, size)), Archive::Mismatch) << size;
  }
  const ScriptInstance instance = run->host->begin("Probe", {});
  EXPECT_THROW(run->host->restore(instance, bytes + "x"), Archive::Mismatch);
}

}  // namespace
}  // namespace lsos
