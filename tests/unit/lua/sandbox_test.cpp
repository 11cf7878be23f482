// Scripts reach only what they may, and can neither hang the program nor exhaust its memory.
#include <chrono>

#include "script_fixture.h"
#include "support/sanitizer.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string error_of(const std::string& text) { return EventRun::of_phase(text)->error(); }

// The value of an expression in a phase, as text.
std::string text_of_expression(const std::string& expression) {
  return std::get<Fail>(EventRun::of_phase("return lsos.fail('%s', " + expression + ")")->run())
      .reason;
}

class AbsentGlobal : public ::testing::TestWithParam<const char*> {};

TEST_P(AbsentGlobal, is_refused) {
  EXPECT_THAT(error_of(std::string("return ") + GetParam()),
              HasSubstr(std::string("no global '") + GetParam() + "'"));
}

INSTANTIATE_TEST_SUITE_P(Sandbox, AbsentGlobal,
                         ::testing::Values("os", "io", "debug", "package", "load", "loadfile",
                                           "dofile", "collectgarbage", "coroutine", "next", "_G",
                                           "loadstring", "warn"));

TEST(Sandbox, library_lacks_what_is_not_repeatable_or_binary) {
  EXPECT_THAT(error_of("return math.random()"), HasSubstr("math has no 'random'"));
  EXPECT_THAT(error_of("math.randomseed(1)"), HasSubstr("math has no 'randomseed'"));
  EXPECT_THAT(error_of("string.dump(function() end)"), HasSubstr("string has no 'dump'"));
  EXPECT_THAT(error_of("return ('').dump"), HasSubstr("string has no 'dump'"));
}

TEST(Sandbox, nothing_shared_can_be_changed) {
  EXPECT_THAT(error_of("string.rep = nil"), HasSubstr("string is read-only"));
  EXPECT_THAT(error_of("rawset(string, 'rep', 1)"),
              HasSubstr("rawset on a table that is read-only"));
  EXPECT_THAT(error_of("rawset(_ENV, 'x', 1)"), HasSubstr("rawset on a table that is read-only"));
  EXPECT_THAT(error_of("setmetatable(string, {})"), HasSubstr("this metatable cannot be changed"));
  EXPECT_THAT(error_of("getmetatable('').__index = 1"), HasSubstr("index a boolean value"));
  EXPECT_THAT(error_of("lsos.done = 1"), HasSubstr("lsos is read-only"));
  EXPECT_THAT(error_of("lsos.dnoe()"), HasSubstr("lsos has no 'dnoe'; did you mean 'done'?"));
}

TEST(Sandbox, assigning_a_global_is_an_error_with_its_line) {
  EXPECT_THAT(
      error_of("local a = 1\nplan = a"),
      HasSubstr("events/Probe.lua:4: Probe 'probe 1' in phase go at 0 s: assignment to global "
                "'plan': make it local"));
  EXPECT_THAT(error_of("pairs = 1"), HasSubstr("assignment to global 'pairs'"));
}

TEST(Sandbox, reading_an_unknown_global_suggests_the_nearest) {
  EXPECT_THAT(error_of("return maths.pi"), HasSubstr("no global 'maths'; did you mean 'math'?"));
}

TEST(Sandbox, only_lsos_and_shared_scripts_can_be_required) {
  EXPECT_THAT(error_of("require 'io'"),
              HasSubstr("require 'io': 'lsos' and scripts of lib/ ('lib/NAME') can be required"));
}

TEST(Sandbox, pairs_goes_through_numbers_then_texts_in_order) {
  EXPECT_EQ(text_of_expression(
                "(function() local t = { z = 1, b = 1, a = 1, [10] = 1, [2] = 1, [1.5] = 1 } "
                "local s = '' for k in pairs(t) do s = s .. k .. ' ' end return s end)()"),
            "1.5 2 10 a b z ");
  EXPECT_THAT(error_of("for _ in pairs { [true] = 1 } do end"),
              HasSubstr("a key is a boolean: only numbers and texts have an order"));
}

TEST(Sandbox, pairs_skips_what_the_loop_removes) {
  EXPECT_EQ(text_of_expression("(function() local t = { a = 1, b = 1, c = 1 } local s = '' "
                               "for k in pairs(t) do s = s .. k t.b = nil end return s end)()"),
            "ac");
}

TEST(Sandbox, no_text_shows_an_address) {
  EXPECT_EQ(text_of_expression("tostring({})"), "table");
  EXPECT_EQ(text_of_expression("tostring(print) .. tostring(rover) .. tostring(lsos.done)"),
            "functionroverlsos.answer");
  EXPECT_EQ(text_of_expression("('%s'):format({})"), "table");
  EXPECT_EQ(text_of_expression(
                "tostring(setmetatable({}, { __tostring = function() return 'mine' end }))"),
            "mine");
  EXPECT_THAT(error_of("string.format('%5p', {})"), HasSubstr("'%p' is not allowed"));
  EXPECT_EQ(text_of_expression("string.format('%d%%p', 5)"), "5%p");
}

TEST(Sandbox, metatables_that_act_at_the_collectors_moment_are_refused) {
  EXPECT_THAT(error_of("setmetatable({}, { __gc = print })"), HasSubstr("'__gc' is not allowed"));
  EXPECT_THAT(error_of("setmetatable({}, { __mode = 'k' })"), HasSubstr("'__mode' is not allowed"));
}

TEST(Sandbox, pcall_and_xpcall_catch_ordinary_errors) {
  EXPECT_EQ(text_of_expression("select(2, pcall(error, 'x', 0))"), "x");
  EXPECT_EQ(text_of_expression("select(3, pcall(function() return 1, 'two' end))"), "two");
  EXPECT_EQ(text_of_expression("select(2, xpcall(error, function(m) return m .. '!' end, 'x', 0))"),
            "x!");
  EXPECT_EQ(text_of_expression("select(2, xpcall(function(a) return a end, print, 'in'))"), "in");
}

TEST(Sandbox, sort_is_stable_and_survives_a_contradicting_order) {
  EXPECT_EQ(text_of_expression("(function() local t = { 'b1', 'a1', 'b2', 'a2', 'c1', 'a3' } "
                               "table.sort(t, function(x, y) return x:sub(1, 1) < y:sub(1, 1) end) "
                               "return table.concat(t, ' ') end)()"),
            "a1 a2 a3 b1 b2 c1");
  EXPECT_EQ(text_of_expression(
                "(function() local t = {} for i = 1, 100 do t[i] = (i * 37) % 101 end "
                "table.sort(t) for i = 2, 100 do assert(t[i - 1] < t[i]) end return #t end)()"),
            "100");
  EXPECT_EQ(text_of_expression("(function() local t = {} for i = 1, 100 do t[i] = i end "
                               "table.sort(t, function() return true end) return #t end)()"),
            "100");
}

// Scripts that would run for minutes or for ever.
class Runaway : public ::testing::TestWithParam<const char*> {};

TEST_P(Runaway, is_stopped_with_its_line) {
  const auto begin = std::chrono::steady_clock::now();
  auto run = EventRun::of_phase(GetParam(), {}, {1'000'000, std::size_t{64} << 20});
  const std::string error = run->error();
  EXPECT_THAT(error,
              HasSubstr("events/Probe.lua:3: Probe 'probe 1' in phase go at 0 s: more than "));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(wall.count(), 10 * test::slowness);
}

INSTANTIATE_TEST_SUITE_P(
    Sandbox, Runaway,
    ::testing::Values(
        "while true do end", "repeat pcall(function() while true do end end) until false",
        "pcall(pcall, function() while true do end end) while true do end",
        "xpcall(function() while true do end end, function() while true do end end)",
        "local s = 'x' while true do s = s .. s end",
        "local t = {} for i = 1, math.huge do t[i] = i end",
        "while true do pcall(string.rep, 'x', 1e6) end",
        "local s = ('x'):rep(1e6) while true do s:upper() end",
        "local s = ('a'):rep(9000) while true do s:find('a*b') end",
        "setmetatable({}, { __index = function(t, k) return t[k + 1] end })[1] = nil "
        "for _ in ipairs(setmetatable({}, { __index = function() return 1 end })) do end"));

TEST(Sandbox, too_much_memory_is_refused_at_its_line) {
  auto run = EventRun::of_phase("local t = {}\nfor i = 1, 1e9 do t[i] = { i } end", {},
                                {1'000'000'000, std::size_t{16} << 20});
  EXPECT_THAT(
      run->error(),
      HasSubstr("events/Probe.lua:4: Probe 'probe 1' in phase go at 0 s: more than 16 MiB of "
                "memory"));
}

TEST(Sandbox, host_works_on_after_a_script_was_stopped) {
  EventRun run("local function go() while true do end end local function on() return lsos.done end",
               "phases = { go = go, on = on }", {}, {1'000'000, std::size_t{16} << 20});
  EXPECT_THAT(run.error(), HasSubstr("more than 1000000 instructions in one call"));
  EXPECT_TRUE(std::holds_alternative<Done>(run.run("on")));
}

TEST(Sandbox, functions_that_loop_inside_c_are_bounded) {
  EXPECT_THAT(error_of("('x'):rep(1e9)"),
              HasSubstr("string.rep would make 1000000000 bytes; at most"));
  EXPECT_THAT(error_of("table.move({}, 1, 1e12, 2)"), HasSubstr("table.move of 1000000000000"));
  EXPECT_THAT(
      error_of("table.insert(setmetatable({}, { __len = function() return 1 << 60 end }), 1, "
               "2)"),
      HasSubstr("table functions take plain tables, not one with '__len'"));
}

TEST(Sandbox, patterns_and_method_calls_are_there) {
  EXPECT_EQ(text_of_expression("('a*b'):rep(1000):find('b', 1, true)"), "3");
  EXPECT_EQ(text_of_expression("('key = value'):match('^(%w+)%s*=%s*(%w+)$')"), "key");
  EXPECT_EQ(text_of_expression("'10' + 1"), "11");
}

TEST(Sandbox, a_mode_that_comes_later_has_no_effect) {
  EXPECT_EQ(
      text_of_expression("(function() local m = {} local t = setmetatable({}, m) m.__mode = 'v' "
                         "m.__gc = print t[1] = {} "
                         "for i = 1, 2e4 do local garbage = { {}, {}, {}, {} } end "
                         "return type(t[1]) .. m.__mode end)()"),
      "tablev");
}

TEST(Sandbox, classes_may_get_their_methods_before_and_after) {
  EXPECT_EQ(
      text_of_expression("(function() local C = {} local o = setmetatable({}, C) C.__index = C "
                         "C.__add = function() return 'sum' end "
                         "function C.name() return 'c' end "
                         "local D = setmetatable({}, C) D.__index = D "
                         "return setmetatable({}, D).name() .. (o + o) .. "
                         "tostring(getmetatable(o) == C) end)()"),
      "csumtrue");
}

TEST(Sandbox, errors_whose_value_is_no_text_name_their_line) {
  for (const char* text : {"error({})", "error()", "assert(false, {})", "assert(false, 'x')",
                           "lsos.fail('%d', 'x')", "table.sort({ 3, 2, 'x' })", "error('x', 0)",
                           "error(setmetatable({}, { __tostring = error }))"}) {
    EXPECT_THAT(error_of(text), ::testing::StartsWith("events/Probe.lua:3: ")) << text;
  }
}

}  // namespace
}  // namespace lsos
