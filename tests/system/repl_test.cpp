// `lsos-host repl` with piped input.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// Words of a shell that executes the prompt with its input from a file.
Words prompt(const std::string& arguments, const std::string& input) {
  return {"sh", "-c", "exec " + program({}).front() + " repl " + arguments + " < " + input};
}

constexpr const char* a_rover =
    "sim = lsos.sim { rovers = { A = { type = 'SEV', events = { { 'Route', at = { 0, 90 } } } } } "
    "}\n";

TEST(Prompt, steps_asks_and_prints_with_units) {
  const TempFolder folder;
  folder.write("input", std::string(a_rover) + R"(sim:run_for(20)
sim.rovers.A.speed_mps
sim:where()
sim.rovers.A.position
sim.events
sim.rovers.A:plan_path({ lsos.vec3(0, 60) })
for i = 1, 2 do
  print('line', i)
end
sim:dispatch('A', 'Pause', { Duration = 60 })
x = 20
x * 2
help 'sleep'
)");
  const Outcome outcome = run_command(prompt("", "input"), {folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex(
                               "^1\\.[0-9]+ m/s\n20 s\nA  'Route 10' in drive  [-0-9.,]+ deg "));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\n[(][^ ]+, [^ ]+, [^ ]+[)] m\n"));
  EXPECT_THAT(outcome.out, HasSubstr(" ready_s = 0 s, "));
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex(" legs = . . duration_s = [0-9.]+ s, energy_j = [0-9.]+ J, "));
  EXPECT_THAT(outcome.out, testing::ContainsRegex(" path = . [(][^()]+[)] m, [(]"));
  EXPECT_THAT(outcome.out, HasSubstr("line\t1\nline\t2\n11\n40\nlsos.sleep(time_s)\n"));
}

TEST(Prompt, says_what_is_wrong_with_its_line_and_goes_on) {
  const TempFolder folder;
  folder.write("input", std::string(a_rover) +
                            "sim:rn()\nsim.rovers.B.speed_mps\n1 +\n+ 2\n'end'\n"
                            "sim:dispatch('A', 'Pause', { Durtion = 5 })\n");
  const Outcome outcome = run_command(prompt("", "input"), {folder.path()});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("prompt:2: sim has no 'rn'; did you mean 'run'?"));
  EXPECT_THAT(outcome.out, HasSubstr("prompt:3: there is no rover 'B'; there are A"));
  EXPECT_THAT(outcome.out, HasSubstr("prompt:5: unexpected symbol near '+'"));
  EXPECT_THAT(outcome.out, HasSubstr("\nend\n"));
  EXPECT_THAT(outcome.out,
              HasSubstr("\nprompt:7: Pause 11: there is no field 'Durtion'; did you mean 'Dur"));
}

TEST(Prompt, takes_up_a_script_that_has_changed) {
  const TempFolder folder;
  const std::string nap =
      "local lsos = require 'lsos'\nreturn lsos.event { api = 1, doc = 'Nap.', phases = { nap = "
      "function(ev) if ev.elapsed_s >= DURATION then return lsos.done end return lsos.sleep(1) end "
      "} "
      "}\n";
  const auto napping = [&](const std::string& duration) {
    std::string text = nap;
    return text.replace(text.find("DURATION"), 8, duration);
  };
  folder.write("events/Nap.lua", napping("1000"));
  folder.write("changed.lua", napping("5"));
  folder.write("input",
               R"(sim = lsos.sim { rovers = { A = { type = 'SEV', events = { { 'Nap' } } } } }
sim:run_for(20)
sim:event('A/10').status
)");
  folder.write("after", "sim:reload()\nsim:run_for(2)\nsim:event('A/10').status\n");
  const Outcome outcome =
      run_command({"sh", "-c",
                   "(cat input; sleep 2; cp changed.lua events/Nap.lua; cat after) | " +
                       program({}).front() + " repl"},
                  {folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out, "running\ncompleted\n");
}

TEST(Prompt, is_stopped_in_a_run_but_not_ended_by_a_signal) {
  const TempFolder folder;
  folder.write(
      "input",
      R"(sim = lsos.sim { max_duration_s = 86400 * 1000, parked_log_interval_s = 2, rovers = { A = { type = 'SEV', events = { { 'Pause', Duration = '1000 d' } } } } }
sim:run_for(86400 * 900)
'still here'
)");
  Process process(prompt("", "input"), {folder.path()});
  std::this_thread::sleep_for(std::chrono::seconds(3));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("stopped at "));
  EXPECT_THAT(outcome.out, HasSubstr("still here"));
}

}  // namespace
}  // namespace lsos::test
