// A mission that goes on and one that was loaded have the same: only what is in ev.state.
#include "support/hidden_state.h"
#include "script_fixture.h"

namespace lsos {
namespace {

using test::HiddenState;
using ::testing::HasSubstr;

class Hidden : public ::testing::TestWithParam<HiddenState> {
 protected:
  Hidden() {
    directory_.write("events/Probe.lua", test::event_of(GetParam()));
    if (!GetParam().shared.empty())
      directory_.write("lib/" + GetParam().name + ".lua", GetParam().shared);
    catalog_ = std::make_unique<Catalog>(std::vector<ScriptFolder>{{directory_.path(), ""}});
    load_errors_ = errors_of(*catalog_, ScriptKind::event, "Probe");
  }

  // What an event writes at each exchange, until it ends or fails. `is_saved`: before each it is
  // written out, thrown away and read back.
  std::string run(LuaHost& host, bool is_saved) const {
    LuaHost* at = &host;
    std::unique_ptr<LuaHost> next;
    RecordingRover rover;
    PhaseContext context{rover, {}, {}, {}, {}, 0, "A", 10, "probe 1"};
    ScriptInstance instance = at->begin("Probe", {});
    std::string told;
    for (int exchange = 0; exchange < 4; ++exchange) {
      context.now = from_seconds(0.1 * exchange);
      if (is_saved) {
        const std::string bytes = at->save(instance);
        next = std::make_unique<LuaHost>(*catalog_);
        at = next.get();
        instance = at->begin("Probe", {});
        at->restore(instance, bytes);
      }
      try {
        at->run_phase(instance, "go", context);
      } catch (const ScriptError& failure) {
        const std::string text = failure.what();
        return told + text.substr(text.find("in phase go at"));
      }
      told += rover.calls.back() + "\n";
    }
    return told;
  }

  ScriptDirectory directory_;
  std::unique_ptr<Catalog> catalog_;
  std::string load_errors_;
};

TEST_P(Hidden, state_is_refused_or_holds_nothing) {
  if (!load_errors_.empty()) {
    EXPECT_THAT(load_errors_, HasSubstr("events/Probe.lua:"));
    ASSERT_FALSE(GetParam().refusal.empty()) << load_errors_;
    EXPECT_THAT(load_errors_, HasSubstr(GetParam().refusal));
    return;
  }
  LuaHost host(*catalog_);
  const std::string first = run(host, false);
  EXPECT_EQ(run(host, true), first);
  EXPECT_EQ(run(host, false), first) << "another event of the type, after the first";
  if (GetParam().refusal.empty()) {
    EXPECT_THAT(first, ::testing::Not(HasSubstr("in phase go at")));
  } else {
    EXPECT_THAT(first, HasSubstr(GetParam().refusal));
  }
}

INSTANTIATE_TEST_SUITE_P(State, Hidden, ::testing::ValuesIn(test::hidden_states()),
                         [](const auto& test) { return test.param.name; });

// They are called before a mission begins, and again when it goes on.
TEST(StateBeside, state_of_functions_that_are_not_phases_holds_nothing) {
  EventRun run(R"(
    local n, letters = 0, ('abcd'):gmatch('%a')
    local function count() n = n + 1 return tostring(n) .. letters() end)",
               "phases = { go = function() end }, check = count, on_abort = count, "
               "open_ended = function() return count() ~= '1a' end");
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(run.host->check("Probe", {}, {}, nullptr, nullptr).fault, "1a");
    EXPECT_FALSE(run.host->is_open_ended("Probe", {}, {}));
  }
  EXPECT_THROW(run.host->run_abort(run.instance, run.context), ScriptError);
}

TEST(StateBeside, state_of_a_phase_that_is_another_event_is_refused) {
  EventRun run(
      R"(
    local n = 0
    local function params() n = n + 1 return { duration_s = n } end)",
      "phases = { go = lsos.sub_event { event = 'Pause', params = params } }");
  EXPECT_THAT(run.error(), HasSubstr("it changed 'n', a local of the file"));
}

TEST(StateBeside, state_of_more_values_than_can_be_looked_at_is_refused) {
  EXPECT_THROW(EventRun("local t = {} for k = 1, 10001 do t[k] = k end\n"
                        "local function go() return t[1] and lsos.done end",
                        "phases = { go = go }"),
               std::runtime_error);
  EventRun fits(
      "local t = {} for k = 1, 9000 do t[k] = k end\n"
      "local function go() return t[1] and lsos.done end",
      "phases = { go = go }");
  EXPECT_TRUE(std::holds_alternative<Done>(fits.run()));
}

}  // namespace
}  // namespace lsos
