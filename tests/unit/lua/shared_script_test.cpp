// Scripts of lib/, which others require.
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A catalog of an event 'Probe' beside scripts of lib/, and runs of it.
class Shared {
 public:
  Shared(const std::vector<std::pair<std::string, std::string>>& scripts, const std::string& head,
         const std::string& phase = "return lsos.done") {
    for (const auto& [name, source] : scripts) directory_.write("lib/" + name + ".lua", source);
    for (const char* event : {"Probe", "Other"}) {
      directory_.write(std::string("events/") + event + ".lua",
                       "local lsos = require 'lsos' " + head +
                           "\nreturn lsos.event { api = 1, doc = 'A probe.', "
                           "phases = { go = function(ev, rover)\n" +
                           phase + "\nend } }\n");
    }
    catalog = std::make_unique<Catalog>(std::vector<ScriptFolder>{{directory_.path(), ""}});
  }

  std::string error() const { return errors_of(*catalog, ScriptKind::event, "Probe"); }

  // What a phase of one of the events throws; "" for nothing.
  std::string run(const std::string& event = "Probe") {
    if (!host_) host_ = std::make_unique<LuaHost>(*catalog);
    RecordingRover rover;
    PhaseContext context{rover, {}, {}, {}, {}, 0, "probe 1", 0, ""};
    context.rover_id = "A";
    try {
      host_->run_phase(host_->begin(event, {}), "go", context);
    } catch (const ScriptError& failure) {
      return failure.what();
    }
    return "";
  }

  std::unique_ptr<Catalog> catalog;

 private:
  ScriptDirectory directory_;
  std::unique_ptr<LuaHost> host_;
};

TEST(SharedScript, gives_its_functions_to_those_that_require_it) {
  Shared shared({{"sums", "return { twice = function(x) return 2 * x end }"}},
                "local sums = require 'lib/sums'", "assert(sums.twice(21) == 42) return lsos.done");
  EXPECT_EQ(shared.error(), "");
  EXPECT_EQ(shared.run(), "");
}

TEST(SharedScript, is_known_as_required_also_through_others) {
  const Shared shared({{"top", "require 'lib/middle' return {}"},
                       {"middle", "require 'lib/low' return {}"},
                       {"low", "return {}"},
                       {"unused", "return {}"}},
                      "require 'lib/low' require 'lib/top'");
  EXPECT_EQ(shared.error(), "");
  EXPECT_THAT(shared.catalog->required_by(ScriptKind::event, "Probe"),
              ElementsAre("low", "middle", "top"));
  EXPECT_TRUE(shared.catalog->required_by(ScriptKind::event, "Absent").empty());
}

TEST(SharedScript, that_is_not_there_is_an_error_with_the_nearest_name) {
  EXPECT_THAT(Shared({{"sums", "return {}"}}, "\nlocal sums = require 'lib/sum'").error(),
              HasSubstr("events/Probe.lua:2: require 'lib/sum': there is no such script; "
                        "did you mean 'lib/sums'?"));
  EXPECT_THAT(Shared({}, "require 'io'").error(),
              HasSubstr("require 'io': 'lsos' and scripts of lib/ ('lib/NAME') can be required"));
}

TEST(SharedScript, with_a_fault_fails_those_that_require_it_with_its_own_line) {
  EXPECT_THAT(Shared({{"sums", "\nreturn 5 +"}}, "require 'lib/sums'").error(),
              HasSubstr("lib/sums.lua:2: "));
  EXPECT_THAT(Shared({{"sums", "\n\nerror 'broken'"}}, "require 'lib/sums'").error(),
              HasSubstr("lib/sums.lua:3: broken"));
  EXPECT_THAT(Shared({{"sums", "return 5"}}, "require 'lib/sums'").error(),
              HasSubstr("require 'lib/sums': lib/sums.lua must return a table, found a number"));
}

TEST(SharedScript, that_is_broken_and_not_required_is_no_matter) {
  const Shared shared({{"sums", "return 5 +"}}, "");
  EXPECT_EQ(shared.error(), "");
  EXPECT_TRUE(shared.catalog->faults().sorted().empty());
}

TEST(SharedScript, cannot_require_itself) {
  EXPECT_THAT(Shared({{"a", "require 'lib/b' return {}"}, {"b", "require 'lib/a' return {}"}},
                     "require 'lib/a'")
                  .error(),
              HasSubstr("lib/b.lua:1: require 'lib/a': it requires itself"));
}

TEST(SharedScript, is_read_only_and_required_while_a_script_loads) {
  const std::vector<std::pair<std::string, std::string>> sums{{"sums", "return { limit = 3 }"}};
  EXPECT_THAT(Shared(sums, "local sums = require 'lib/sums'", "sums.limit = 4").run(),
              HasSubstr("lib/sums is read-only, 'limit' cannot be assigned"));
  EXPECT_THAT(Shared(sums, "local sums = require 'lib/sums'", "return sums.limits").run(),
              HasSubstr("lib/sums has no 'limits'; did you mean 'limit'?"));
  EXPECT_THAT(Shared(sums, "", "require 'lib/sums'").run(),
              HasSubstr("require 'lib/sums': only at the head of a script in events/, rovers/ or "
                        "terrain/"));
}

// Else a mission that continues would differ from one that was loaded.
TEST(SharedScript, keeps_nothing_between_two_phases) {
  const char* counter =
      "local count = 0 return { add = function() count = count + 1 return count end }";
  Shared shared({{"counter", counter}}, "local counter = require 'lib/counter'",
                "assert(counter.add() == 1) return lsos.done");
  EXPECT_THAT(shared.run("Probe"), HasSubstr("it changed 'count', a local of the file"));
  EXPECT_THAT(shared.run("Probe"), HasSubstr("it changed 'count', a local of the file"));
  EXPECT_THAT(shared.run("Other"), HasSubstr("it changed 'count', a local of the file"));
  const char* in_a_table =
      "local m = { count = 0 } function m.add() m.count = m.count + 1 end return m";
  Shared tabled({{"counter", in_a_table}}, "local counter = require 'lib/counter'",
                "counter.add() return lsos.done");
  EXPECT_THAT(tabled.run(), HasSubstr("it changed "));
}

TEST(SharedScript, is_not_shared_by_two_scripts_while_they_load) {
  const char* counter =
      "local count = 0 return { add = function() count = count + 1 return count end }";
  const Shared shared({{"counter", counter}},
                      "local counter = require 'lib/counter' assert(counter.add() == 1)");
  EXPECT_EQ(shared.error(), "");
  EXPECT_EQ(errors_of(*shared.catalog, ScriptKind::event, "Other"), "");
}

}  // namespace
}  // namespace lsos
