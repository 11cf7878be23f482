// `lsos-host test`: the shipped scenarios, and the output and files of a failing one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/run_folder.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Outcome test(const TempFolder& folder, Words more) {
  Words words{"test"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words, {folder.path()});
}

const std::string two_scenarios = R"(local lsos = require 'lsos'

local function paused(duration)
  local sim = lsos.sim { rovers = { A = { type = 'SEV', events = { { 'Pause', Duration = duration } } } } }
  sim:run()
  return sim
end

lsos.scenario('good', function(t)
  t:near(paused(10).time_s, '10 s', '1 s')
end)

lsos.scenario('bad', function(t)
  t:near(paused(20).time_s, '2 min', '1 s', 'the whole pause')
end)
)";

// One test a file, so that those of whole days run side by side.
class ShippedScenarios : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedScenarios, pass) {
  const TempFolder folder;
  const std::string file = "tests/scenarios/" + GetParam() + ".lua";
  const Outcome outcome = run({"test", file, "-o", folder / "logs"}, {LSOS_SOURCE_DIR});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("TAP version 14\nok 1 - " + file));
}

std::vector<std::string> scenario_files() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(repository() / "tests/scenarios")) {
    names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ShippedScenarios, ::testing::ValuesIn(scenario_files()),
                         [](const auto& tested) { return tested.param; });

TEST(Scenarios, of_a_folder_are_run_together_and_keep_no_log_when_they_pass) {
  const TempFolder folder;
  std::string good = two_scenarios;
  good.resize(good.find("lsos.scenario('bad'"));
  folder.write("tests/scenarios/one.lua", good);
  folder.write("tests/scenarios/two.lua", good);
  const Outcome outcome = test(folder, {"tests/scenarios", "-o", folder / "logs"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ok 1 - tests/scenarios/one.lua: good"));
  EXPECT_THAT(outcome.out, HasSubstr("ok 2 - tests/scenarios/two.lua: good"));
  EXPECT_FALSE(fs::exists(folder / "logs/one/good"));
}

TEST(Scenarios, that_fail_say_what_was_expected_and_found_and_when_and_keep_their_log) {
  const TempFolder folder;
  folder.write("tests/scenarios/two.lua", two_scenarios);
  const Outcome outcome = test(folder, {"--junit", folder / "results.xml"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("ok 1 - tests/scenarios/two.lua: good"));
  EXPECT_THAT(outcome.out, HasSubstr("not ok 2 - tests/scenarios/two.lua: bad"));
  EXPECT_THAT(outcome.out, HasSubstr("tests/scenarios/two.lua:14: the whole pause: expected 2 min "
                                     "within 1 s, found 0.333333 min, at 20 s"));
  EXPECT_THAT(outcome.out, HasSubstr("log: out/scenarios/two/bad\n"));
  EXPECT_THAT(outcome.out, HasSubstr("1..2\n"));
  EXPECT_TRUE(fs::exists(folder / "out/scenarios/two/bad/sim1/log.gpkg"));
  EXPECT_TRUE(fs::exists(folder / "out/scenarios/two/bad/sim1/overlay.kml"));
  EXPECT_FALSE(fs::exists(folder / "out/scenarios/two/good"));
  const std::string junit = read_text(folder / "results.xml");
  EXPECT_THAT(junit, HasSubstr("tests=\"2\" failures=\"1\""));
  EXPECT_THAT(junit, HasSubstr("name=\"bad\""));
}

TEST(Scenarios, are_chosen_by_a_part_of_their_name_and_told_as_json) {
  const TempFolder folder;
  folder.write("tests/scenarios/two.lua", two_scenarios);
  const Outcome outcome = test(folder, {"--filter", "goo", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  const json results = json::parse(outcome.out);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0]["name"], "good");
  EXPECT_EQ(results[0]["failure"], "");
  const Outcome none = test(folder, {"--filter", "nothing"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("no scenario has 'nothing' in its name"));
}

TEST(Scenarios, that_do_not_load_or_are_none_fail) {
  const TempFolder folder;
  folder.write("tests/scenarios/broken.lua", "local lsos = require 'lsos'\nlsos.scenari('x')\n");
  folder.write("tests/scenarios/empty.lua", "-- nothing yet\n");
  const Outcome outcome = test(folder, {});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("tests/scenarios/broken.lua:2: lsos has no 'scenari'; did you "
                                     "mean 'scenario'?"));
  EXPECT_THAT(outcome.out, HasSubstr("has no lsos.scenario(name, function)"));
  const Outcome nowhere = run({"test", "nowhere"}, {folder.path()});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("nowhere: there is no such file or folder of scenarios"));
}

TEST(Scenarios, that_do_harm_do_it_to_themselves_alone) {
  const TempFolder folder;
  folder.write("tests/scenarios/kept.lua", R"(local lsos = require 'lsos'
local keep
local function made() return lsos.sim { rovers = { A = { type = 'SEV' } } } end
lsos.scenario('one', function() keep = made() end)
lsos.scenario('two', function() return keep.time_s end)
lsos.scenario('a-b', function(t) made() t:check(false) end)
lsos.scenario('a b', made)
lsos.scenario('caught', function(t) pcall(t.equal, t, 1, 2) end)
lsos.scenario('a # TODO\nline', function(t) t:equal({ 1, x = { 2 } }, { 1, x = { 3 } }) end)
lsos.scenario('wrong unit', function(t) t:near(2.5, '7.2 km/h', '1 m') end)
lsos.scenario('late', function() lsos.scenario('x', made) end)
)");
  const Outcome outcome = test(folder, {"--junit", folder / "results.xml"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("ok 1 - tests/scenarios/kept.lua: one"));
  EXPECT_THAT(outcome.out, HasSubstr("kept.lua:5: this simulation has ended with the scenario that "
                                     "made it"));
  EXPECT_TRUE(fs::exists(folder / "out/scenarios/kept/a_b/sim1/log.gpkg")) << "of the failed one";
  EXPECT_THAT(outcome.out, HasSubstr("ok 4 - tests/scenarios/kept.lua: a b"));
  EXPECT_THAT(outcome.out, HasSubstr("not ok 5 - tests/scenarios/kept.lua: caught"));
  EXPECT_THAT(outcome.out, HasSubstr("not ok 6 - tests/scenarios/kept.lua: a \\# TODO line #"));
  EXPECT_THAT(outcome.out, HasSubstr("expected { 1, x = { 3 } }, found { 1, x = { 2 } }"));
  EXPECT_THAT(outcome.out, HasSubstr("'km/h' is a speed, 'm' a length"));
  EXPECT_THAT(outcome.out, HasSubstr("only while a file of scenarios loads"));
  const Outcome read = run_command({"python3", "-c",
                                    "import sys, xml.etree.ElementTree as e; "
                                    "print(len(e.parse(sys.argv[1]).getroot()))",
                                    folder / "results.xml"});
  EXPECT_EQ(read.out, "8\n") << read.err;
}

// Each mistake that is possible in a table of lsos.sim or in a call of a simulation.
TEST(Scenarios, say_what_is_wrong_with_a_table_or_a_call) {
  const auto plan = [](const std::string& events) {
    return "lsos.sim { rovers = { A = { type = 'SEV', events = " + events + " } } }";
  };
  const std::string sim = "local sim = " + plan("{ { 'Pause', Duration = 60 } }") + " ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"t:check('charge > 1000')", "found the text 'charge > 1000', which is always true"},
      {sim + "local a = sim:event('A/10').state",
       "an event has no 'state'; did you mean 'status'?"},
      {"lsos.sim {}", "lsos.sim: 'rovers' is missing: Id = { type = 'SEV', "},
      {"lsos.sim { rovers = {} }",
       "rovers is empty; at least one is wanted: Id = { type = 'SEV', "},
      {"lsos.sim { rovers = 'SEV' }", "rovers: a table is wanted, found a text"},
      {"lsos.sim { rovers = { {} } }", "rovers: entries have names: Id = { type = 'SEV', "},
      {"lsos.sim { rovers = { A = 'SEV' } }", "rovers: A: a table is wanted, found a text"},
      {"lsos.sim { rovers = { A = {} } }", "rover A: 'type' is missing: Its script in rovers/"},
      {"lsos.sim { rovers = { A = { type = 'SEW' } } }",
       "there is no such rover type; did you mean 'SEV'?"},
      {"lsos.sim { rover = { A = { type = 'SEV' } } }", "did you mean 'rovers'?"},
      {"lsos.sim { site = { 1 }, rovers = { A = { type = 'SEV' } } }",
       "site: { lon_deg, lat_deg } is wanted"},
      {"lsos.sim { site = { 500, 100 }, rovers = { A = { type = 'SEV' } } }",
       "site: { lon_deg, lat_deg } is wanted, -360..360 and -90..90"},
      {"lsos.sim { rovers = { A = { type = 'SEV', at = 'here' } } }",
       "at: { east_m, north_m } is wanted"},
      {plan("'Pause'"), "events: a list is wanted, found a text"},
      {plan("{ 'Pause' }"), "an event is a table that begins with its type: { 'Pause', Duration"},
      {plan("{ x = { 'Pause' } }"), "rover A: events: a list without gaps is wanted"},
      {plan("{ { 'Pause', { 1 } } }"), "Pause: a list has no place here"},
      {plan("{ { 'Pause', Duration = {} } }"),
       "Pause: Duration: a number, text or boolean is wanted, found a table"},
      {plan("{ { 'Route', at = 'home' } }"), "Route: at: { east_m, north_m } is wanted"},
      {plan("{ { 'Route', path = 'home' } }"),
       "Route: path: a list of { east_m, north_m } is wanted, found a text"},
      {plan("{ { 'Route', path = { { 1, 2 }, {} } } }"),
       "Route: path[2]: { east_m, north_m } is wanted"},
      {plan("{ { 'Route', path = { { 0, 50 } } } }"),
       "Route: path: 1 places; 2 or more are wanted"},
      {plan("{ { 'Survey', polygon = { { 0, 0 }, { 50, 0 } } } }"),
       "Survey: polygon: 2 places; 3 or more are wanted"},
      {"lsos.sim 'nowhere.kml'", "nowhere.kml"},
      {sim + "sim:run_for('1 parsec')", "'parsec'"},
      {sim + "sim:run_for('1 kg')", "'kg'"},
      {sim + "sim:run_for(-1)", "run_for: -1 s; 0 to "},
      {sim + "sim:event('A/20')", "there is no event 'A/20'"},
      {sim + "return sim.rovers.B", "there is no rover 'B'; there are A"},
      {sim + "sim:shade('A', 2)", "sim:shade: 2; a share of the sunlight is 0 to 1"},
      {sim + "sim:shade('B', 0)", "there is no rover 'B'"},
      {sim + "sim:load('nowhere')", "nowhere cannot be opened: No such file"},
      {sim + "t:near(1, '1 parsec', 1)", "'1 parsec': no unit 'parsec'"},
      {sim + "t:near(1, 'a m', 1)", "'a m': "},
      {sim + "t:fails(function() end, 'broken')", "expected an error with 'broken', found none"},
      {sim + "t:fails(function() error('torn') end, 'broken')",
       "expected an error with 'broken', found '"},
  };
  std::string text = "local lsos = require 'lsos'\n";
  for (const auto& [mistake, message] : cases) {
    text += "lsos.scenario([==[" + mistake + "]==], function(t) " + mistake + " end)\n";
  }
  const TempFolder folder;
  folder.write("tests/scenarios/wrong.lua", text);
  const Outcome outcome = test(folder, {"--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json results = json::parse(outcome.out);
  ASSERT_EQ(results.size(), cases.size());
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const std::string line = "tests/scenarios/wrong.lua:" + std::to_string(k + 2) + ": ";
    const auto failure = results[k]["failure"].get<std::string>();
    EXPECT_THAT(failure, HasSubstr(line)) << cases[k].first;
    EXPECT_THAT(failure, HasSubstr(cases[k].second)) << cases[k].first;
  }
}

// Three scenarios run in parallel; one file has the name that the second file of another name gets.
TEST(Scenarios, of_files_of_one_name_keep_their_logs_apart) {
  const TempFolder folder;
  const std::string text =
      "local lsos = require 'lsos'\n"
      "lsos.scenario('same', function(t)\n"
      "  local sim = lsos.sim { rovers = { A = { type = 'SEV', events = {{ 'Pause', Duration = 5 "
      "}} "
      "} } }\n"
      "  sim:run() t:equal(sim.time_s, 6)\n"
      "end)\n";
  for (const char* file : {"a/x.lua", "b/x.lua", "c/x_2.lua"}) folder.write(file, text);
  const Outcome outcome =
      run({"test", "a/x.lua", "b/x.lua", "c/x_2.lua", "--threads", "3"}, {folder.path()});
  EXPECT_EQ(outcome.exit_code, 1);
  for (const char* kept : {"x", "x_2", "x_3"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out/scenarios" / kept)) << kept << outcome.out;
  }
}

// The tables are deeper than a C function's share of Lua's stack.
TEST(Scenarios, compare_and_show_tables_in_tables) {
  const TempFolder folder;
  folder.write("tests/scenarios/deep.lua", R"(local lsos = require 'lsos'
local function deep(n, leaf) return n == 0 and leaf or { deep(n - 1, leaf) } end
lsos.scenario('equal', function(t) t:equal(deep(15, 1), deep(15, 1)) end)
lsos.scenario('another', function(t) t:equal(deep(15, 1), deep(15, 2)) end)
)");
  const Outcome outcome = test(folder, {});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("\nok 1 - "));
  EXPECT_THAT(outcome.out, HasSubstr("expected { { { {"));
}

// The same plan given by a table and by a file, with events of the working folder.
TEST(Scenarios, find_events_beside_them_and_read_plans) {
  const TempFolder folder;
  folder.write("events/Nap.lua", R"(local lsos = require 'lsos'
return lsos.event {
  api    = 1,
  doc    = 'Sleep a little.',
  phases = { nap = function(ev) return ev.elapsed_s >= 5 and lsos.done or lsos.sleep(5) end },
}
)");
  folder.write("tests/scenarios/nap.lua", R"(local lsos = require 'lsos'
lsos.scenario('nap', function(t)
  local sim = lsos.sim { rovers = { A = { type = 'SEV', events = { { 'Nap' } } } } }
  sim:run()
  t:near(sim:event('Nap 10').end_s, 5, 0)
  local again = lsos.sim 'nap.kml'
  again:run()
  t:near(again:event('A/10').end_s, 5, 0)
end)
)");
  folder.write("nap.kml", run({"schema", "Nap"}, {folder.path()}).out);
  const Outcome outcome = test(folder, {});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST(Scenarios, reload_scripts_from_where_they_found_them) {
  const TempFolder folder;
  folder.write("events/Nap.lua",
               "local lsos = require 'lsos'\nreturn lsos.event { api = 1, doc = 'Nap.', "
               "phases = { nap = function() return lsos.done end } }\n");
  folder.write("checks/nap.lua",
               "local lsos = require 'lsos'\nlsos.scenario('nap', function(t)\n"
               "  local sim = lsos.sim { rovers = { A = { type = 'SEV', events = { { 'Pause', "
               "Duration = 5 }, { 'Nap' } } } } }\n"
               "  sim:reload()\n  sim:run()\n  t:equal(sim:event('A/20').status, 'completed')\n"
               "end)\n");
  const Outcome outcome = test(folder, {"checks/nap.lua"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST(Schema, gives_its_fields_as_json_and_examples_within_their_limits) {
  const TempFolder folder;
  folder.write("events/Nap.lua",
               "local lsos = require 'lsos'\nreturn lsos.event { api = 1, doc = 'Nap.', "
               "phases = { nap = function() return lsos.done end }, params = { depth_m = "
               "lsos.number { kml = 'Depth', unit = 'km', min = 4 / 3, required = true, doc = 'Of "
               "the bed.' }, count = lsos.integer { kml = 'Count', min = 10000000000, required = "
               "true, doc = 'Of beds.' } } }\n");
  const Outcome outcome = run({"schema", "Nap", "--json"}, {folder.path()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json kinds = json::parse(outcome.out);
  EXPECT_EQ(kinds[0]["name"], "MissionInfo");
  EXPECT_EQ(kinds.back()["name"], "Nap");
  const json& fields = kinds.back()["fields"];
  const auto depth =
      std::ranges::find_if(fields, [](const json& f) { return f["name"] == "Depth"; });
  ASSERT_NE(depth, fields.end());
  EXPECT_EQ((*depth)["doc"], "Of the bed.");
  EXPECT_THAT((*depth)["example"].get<std::string>(), StartsWith("1.3333"));
  folder.write("form.kml", run({"schema", "Nap"}, {folder.path()}).out);
  EXPECT_EQ(run({"check", "form.kml"}, {folder.path()}).exit_code, 0);
}

TEST(Schema, is_a_plan_that_reads) {
  const TempFolder folder;
  const Outcome all = run({"schema"}, {folder.path()});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  for (const char* name : {"MissionInfo", "Rover", "Route", "Survey", "EVA"}) {
    EXPECT_THAT(all.out, HasSubstr("<Schema name=\"" + std::string(name) + "\" id=\"" + name));
  }
  const Outcome some = run({"schema", "Pause", "Route"}, {folder.path()});
  folder.write("form.kml", some.out);
  const Outcome check = run({"check", "form.kml"}, {folder.path()});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  const Outcome wrong = run({"schema", "Puase"}, {folder.path()});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("there is no event 'Puase'; did you mean 'Pause'?"));
  folder.write("events/Nap.lua", "local lsos = require 'lsos'\nreturn lsos.event { api = 1 }\n");
  const Outcome broken = run({"schema", "Nap"}, {folder.path()});
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_THAT(broken.err, HasSubstr("events/Nap.lua:2: "));
}

// A forgotten return is the likeliest slip in a script. It is no fault, because a phase may return
// nothing.
TEST(ForgottenReturn, is_warned_of_after_an_hour_and_ends_with_the_scenario_s_day) {
  const TempFolder folder;
  folder.write(
      "events/Nap.lua",
      "local lsos = require 'lsos'\nlocal function go() local x = lsos.done end\n"
      "return lsos.event { api = 1, doc = 'Test.', start = 'go', phases = { go = go } }\n");
  const std::string scenario = folder.write(
      "nap.lua",
      "local lsos = require 'lsos'\nlsos.scenario('nap', function(t)\n"
      "  local sim = lsos.sim { rovers = { A = { type = 'SEV', events = { { 'Nap' } } } } }\n"
      "  sim:run()\n  t:near(sim.time_s, '1 d', '1 s')\n"
      "  t:equal(sim:event('A/10').reason,\n"
      "    \"MaxDuration is over, in phase 'go' since 0 s\")\nend)\n");
  const Outcome outcome = test(folder, {scenario});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;

  folder.write("nap.kml", kml({{"MissionInfo",
                                {{"Planet", "Moon"},
                                 {"StartTime", "2026-01-01"},
                                 {"Terrain", "Flat"},
                                 {"MaxDuration", "2 h"}},
                                ""},
                               {"Rover", {{"RoverId", "A"}, {"RoverType", "SEV"}}, point("0,0")},
                               event("Nap", "A", 1, {}, "")}));
  run({"run", "nap.kml", "--quiet", "--no-report"}, {folder.path()});
  const auto warnings = summary(folder / "out" / "nap")["warnings"].dump();
  EXPECT_THAT(warnings, HasSubstr("phase 'go' of Nap has answered nothing for an hour"));
  EXPECT_THAT(warnings, HasSubstr("does a 'return lsos.done' lack"));
}

}  // namespace
}  // namespace lsos::test
