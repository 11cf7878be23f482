// Lines that the prompt prints, without a simulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "lua/runtime/handle.h"
#include "lua/session/reference.h"
#include "lua/session/repl.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

class PromptLines : public ::testing::Test {
 protected:
  std::vector<std::string> printed(const std::string& line) {
    lines_.clear();
    repl_.run(line);
    return lines_;
  }
  std::vector<std::string> completions(const std::string& text) { return repl_.completions(text); }
  Repl::Outcome outcome(const std::string& line) { return repl_.run(line); }
  // The lines printed when Ctrl-C is pressed while the line runs.
  std::vector<std::string> printed_when_interrupted(const std::string& line) {
    std::thread user([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      ::kill(::getpid(), SIGINT);
    });
    const std::vector<std::string> lines = printed(line);
    user.join();
    return lines;
  }

 private:
  std::vector<std::string> lines_;
  Repl repl_{"", ::testing::TempDir(), [this](const std::string& line) { lines_.push_back(line); }};
};

TEST_F(PromptLines, give_no_unit_to_what_only_stands_beside_a_name) {
  EXPECT_THAT(printed("a = { speed_mps = 2, time_s = 8 }"), IsEmpty());
  EXPECT_THAT(printed("a.speed_mps, a.time_s"), ElementsAre("2 m/s", "8 s"));
  EXPECT_THAT(printed("return a.time_s"), ElementsAre("8 s"));
  EXPECT_THAT(printed("a.speed_mps --[[ v ]] / a.time_s"), ElementsAre("0.25"));
  EXPECT_THAT(printed("[[it's]], a.time_s"), ElementsAre("it's", "8"));
  EXPECT_THAT(printed("local x, time_s, b = 1, 2, 3 return b, 7"), ElementsAre("3", "7"));
  EXPECT_THAT(printed("(function(q) return 1, a.time_s end)(), 5").back(), EndsWith("5"));
}

TEST_F(PromptLines, that_are_very_long_are_read_all_the_same) {
  const std::string brackets(300'000, '('), letters(200'000, 'a');
  EXPECT_THAT(printed("#[[" + brackets + "]]"), ElementsAre("300000"));
  EXPECT_THAT(printed("local " + letters + " = 1"), IsEmpty());
}

TEST_F(PromptLines, show_tables_that_hold_each_other_as_far_as_a_line_goes) {
  EXPECT_THAT(printed("w = {} for i = 1, 20 do w[i] = w end"), IsEmpty());
  const std::vector<std::string> lines = printed("w");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_LT(lines.front().size(), 20'000u);
}

TEST_F(PromptLines, show_values_and_what_tables_hold) {
  EXPECT_THAT(printed("lsos.vec3(1, 2, 3)"), ElementsAre("(1, 2, 3)"));
  EXPECT_THAT(printed("{ b = 2, a = 'x' }"), ElementsAre("table\n  a = x\n  b = 2"));
  EXPECT_THAT(printed("{ [true] = 1 }"), ElementsAre("table\n  (with a boolean as a key)"));
  EXPECT_THAT(printed("1, nil, 'two'"), ElementsAre("1", "nil", "two"));
  EXPECT_THAT(printed("x = 5"), IsEmpty());
  EXPECT_THAT(printed("x"), ElementsAre("5"));
  EXPECT_THAT(
      printed("(function() local t = {} for i = 1, 300 do t[i] = i end return t end)()").front(),
      HasSubstr("\n  200 = 200\n  and 100 more"));
}

TEST_F(PromptLines, show_quantities_within_tables_with_their_units) {
  printed(
      "a = { start_s = 5, ends_s = { 1, 2.5 }, n = 3, reason = 'none', nested = { { load_w = 5.0 } "
      "} }");
  EXPECT_THAT(printed("a"), ElementsAre("table\n  ends_s = { 1 s, 2.5 s }\n  n = 3\n"
                                        "  nested = { { load_w = 5 W } }\n  reason = none\n"
                                        "  start_s = 5 s"));
  EXPECT_THAT(printed("a.ends_s"), ElementsAre("table\n  1 = 1 s\n  2 = 2.5 s"));
  EXPECT_THAT(printed("{ { a, { lat_deg = 4.25, used_kwh = 1 } } }").front(),
              EndsWith(" start_s = 5 s }, { lat_deg = 4.25 deg, used_kwh = 1 kWh } }"));
}

TEST_F(PromptLines, show_places_in_metres) {
  printed(
      "rover = { position = lsos.vec3(1, 2, 1 / 3), path = { lsos.vec3(4, 5, 6) }, size_m = "
      "lsos.vec3(7, 8, 9) }");
  EXPECT_THAT(printed("rover"),
              ElementsAre("table\n  path = { (4, 5, 6) m }\n  position = (1, 2, 0.333333333) m\n"
                          "  size_m = (7, 8, 9) m"));
  EXPECT_THAT(printed("rover.position"), ElementsAre("(1, 2, 0.333333333) m"));
  EXPECT_THAT(printed("rover.path[1]"), ElementsAre("(4, 5, 6) m"));
  EXPECT_THAT(printed("rover.path[1].z, rover.size_m:length()"),
              ElementsAre("6 m", "13.9283883 m"));
  EXPECT_THAT(printed("{ position = { x = 1, y = 2, 3 } }"),
              ElementsAre("table\n  position = { 3 m, x = 1 m, y = 2 m }"));
}

TEST_F(PromptLines, show_the_unit_of_each_value_and_of_no_other) {
  printed("a = { speed_mps = 2, time_s = 8, wait_s = function(n) return n, 'so long', n end }");
  EXPECT_THAT(printed("a.time_s, a['speed_mps']"), ElementsAre("8 s", "2 m/s"));
  EXPECT_THAT(printed("return -a.time_s, 'a.time_s', 3 -- a.time_s"),
              ElementsAre("-8 s", "a.time_s", "3"));
  EXPECT_THAT(printed("a.wait_s(5)"), ElementsAre("5 s", "so long", "5 s"));
  EXPECT_THAT(printed("(a).wait_s(a.speed_mps), #{ a.time_s }, a.time_s;"),
              ElementsAre("2 s", "1", "8 s"));
  EXPECT_THAT(printed("a.speed_mps * a.time_s, a.time_s == 8, 2 ^ a.time_s"),
              ElementsAre("16", "true", "256"));
}

// The name of a field of an object must say its unit, unless it has none.
TEST_F(PromptLines, know_the_unit_of_all_that_objects_have) {
  const std::set<std::string> ratios{"slip", "charge", "sun_fraction", "incidence"};
  for (const HandleType* type : scripted_objects()) {
    for (const HandleField& field : type->fields) {
      const std::string name = field.name, kind = field.type;
      const bool is_place = kind.find("vec3") != std::string::npos;
      if ((kind != "number" && !is_place) || ratios.contains(name)) continue;
      const std::string value = is_place ? "{ lsos.vec3(1, 2, 3) }" : "{ 1 }";
      EXPECT_THAT(printed("{ " + name + " = " + value + " }").front(),
                  MatchesRegex(".* [^ ]*[a-zA-Z/]+ }"))
          << type->name << "." << name;
    }
  }
}

TEST_F(PromptLines, are_completed_with_what_the_libraries_have) {
  EXPECT_THAT(completions("lsos.vec"), ElementsAre("lsos.vec3"));
  EXPECT_THAT(completions("1 + math.flo"), ElementsAre("math.floor"));
  EXPECT_THAT(completions("tos"), ElementsAre("tostring"));
  printed("tally = { towed = { 1 } }");
  EXPECT_THAT(completions("tally.to"), ElementsAre("tally.towed"));
  EXPECT_THAT(completions("nothing.x"), IsEmpty());
}

TEST_F(PromptLines, show_tables_within_tables_on_their_line) {
  EXPECT_THAT(
      printed("{ { name = 'drop', fields = { n = 3 } }, { lsos.vec3(1, 2, 3) } }"),
      ElementsAre("table\n  1 = { fields = { n = 3 }, name = 'drop' }\n  2 = { (1, 2, 3) }"));
  EXPECT_THAT(printed("{ { [true] = 1 } }"),
              ElementsAre("table\n  1 = { with a boolean as a key }"));
  EXPECT_THAT(printed("{ { string.rep('x', 300) } }").front(), EndsWith("xxx..."));
  // The cut must not split a UTF-8 character.
  for (const int before : {195, 196, 197, 198}) {
    const std::string line =
        "{ { string.rep('x', " + std::to_string(before) + ") .. string.rep('ä', 50) } }";
    const std::string end = printed(line).front().substr(200);
    EXPECT_THAT(end, MatchesRegex("[^\xc3]*(\xc3\xa4)*\\.\\.\\."));
  }
}

TEST_F(PromptLines, help_knows_all_that_scripts_are_given) {
  EXPECT_THAT(printed("help()").front(), HasSubstr("sim:run_for(60)"));
  EXPECT_THAT(printed("help 'sleep'").front(), StartsWith("lsos.sleep(time_s)\n"));
  EXPECT_THAT(printed("help 'lsos.sleep'"), printed("help 'sleep'"));
  EXPECT_THAT(printed("help 'done'").front(),
              HasSubstr("lsos.done\n  Answer: the event is completed"));
  EXPECT_THAT(printed("help 'event'").front(), HasSubstr("lsos.event {...}\n"));
  EXPECT_THAT(printed("help 'ev'").front(), StartsWith("ev: "));
  EXPECT_THAT(printed("help 't'").front(), HasSubstr("t:near(found, wanted, within, what)"));
  EXPECT_THAT(printed("help 'run_for'").front(), StartsWith("sim:run_for(duration_s)\n"));
  EXPECT_THAT(printed("help 'rover.speed_mps'").front(), StartsWith("rover.speed_mps  (number)\n"));
  EXPECT_THAT(
      printed("help 'sleeep'"),
      ElementsAre("there is no 'sleeep'; did you mean 'sleep'?; help() says what there is"));
}

TEST_F(PromptLines, quit_and_exit_end) {
  for (const std::string line : {"quit", "exit", "quit()", " exit () "}) {
    EXPECT_EQ(outcome(line), Repl::Outcome::ended) << line;
  }
  EXPECT_EQ(outcome("x = 'quit'"), Repl::Outcome::done);
}

TEST_F(PromptLines, a_value_that_cannot_be_shown_is_an_error_like_others) {
  EXPECT_THAT(printed("setmetatable({}, { __tostring = function() error('no text') end })"),
              ElementsAre("prompt:1: no text"));
  EXPECT_THAT(printed("setmetatable({}, { __tostring = function() return 5 end })"),
              ElementsAre(HasSubstr("'__tostring' must give a text")));
}

TEST_F(PromptLines, a_local_of_an_earlier_line_is_explained) {
  printed("local depth_m, width_m = 5, 6");
  EXPECT_THAT(printed("depth_m * 2"),
              ElementsAre(HasSubstr("no global 'depth_m'; a local lasts to the end of its line")));
  EXPECT_THAT(printed("height_m").front(), Not(HasSubstr("a local lasts")));
}

TEST_F(PromptLines, are_stopped_by_ctrl_c) {
  EXPECT_THAT(printed_when_interrupted("while true do end"), ElementsAre("prompt:1: stopped"));
  EXPECT_THAT(printed_when_interrupted("while true do pcall(error) end"),
              ElementsAre("prompt:1: stopped"));
  EXPECT_THAT(printed_when_interrupted(
                  "setmetatable({}, { __tostring = function() while true do end end })"),
              ElementsAre("prompt:1: stopped"));
  EXPECT_THAT(printed("'still here'"), ElementsAre("still here"));
}

}  // namespace
}  // namespace lsos
