// What a text of Lua may take to compile.
#include "lua/runtime/source_budget.h"

#include <gmock/gmock.h>

#include <cstring>

#include "lua/api/api.h"
#include "lua/runtime/state.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string fault(const std::string& source) {
  const auto found = source_fault(source);
  return found ? std::to_string(found->line) + ": " + found->what : "";
}

TEST(SourceBudget, counts_and_and_or_of_one_expression) {
  EXPECT_EQ(fault("return a" + repeated(" or a", terms_max)), "");
  EXPECT_THAT(fault("return\n a" + repeated(" and\n a", terms_max + 1)),
              StartsWith("1002: more than 1000 'and' and 'or' in one expression"));
  EXPECT_NE(fault("if a" + repeated(" or a and b", terms_max) + " then end"), "");
  // Lists of the parser pass out of brackets round a part, but not out of those of a call.
  EXPECT_NE(fault("x = " + repeated("(a or b) or ", terms_max) + "c"), "");
  EXPECT_NE(fault("x = ((" + repeated("a or ", terms_max) + "b) or c)"), "");
  EXPECT_EQ(fault(repeated("f(a or b, c and d) ", 2 * terms_max)), "");
  EXPECT_EQ(fault("return {" + repeated("{ x = a and b or c },\n", 2 * terms_max) + "}"), "");
  EXPECT_EQ(fault(repeated("do local x = a or b end ", 2 * terms_max)), "");
}

TEST(SourceBudget, counts_elseif_of_one_if_and_jumps_of_a_text) {
  EXPECT_EQ(fault("if a then" + repeated(" elseif b then", terms_max) + " end"), "");
  EXPECT_THAT(fault("if a then" + repeated(" elseif b then", terms_max + 1) + " end"),
              HasSubstr("'elseif'"));
  EXPECT_EQ(fault(repeated("if a then b() elseif c then d() end ", 2 * terms_max)), "");
  EXPECT_EQ(fault("while a do " + repeated("if a then break end ", jumps_max) + "end"), "");
  for (const std::string jump : {"if a then break end ", "goto x ", "do ::x:: end "}) {
    EXPECT_THAT(fault(repeated(jump, jumps_max + 1)), HasSubstr("labels")) << jump;
  }
}

TEST(SourceBudget, counts_no_words_of_texts_and_comments) {
  const std::string words = repeated("or ", 2 * terms_max);
  for (const std::string& source :
       {"return '" + words + "'", "return \"\\\"" + words + "\"",
        "return [==[ ]] " + words + "]==]", "-- " + words, "--[[\n" + words + "]]",
        "return 'a\\z \n " + words + "'", "return 'a\\\n " + words + "'"}) {
    EXPECT_EQ(fault(source), "") << source.substr(0, 20);
  }
  // What only looks like the end of a text or the begin of a comment hides nothing.
  for (const std::string begin :
       {"x = '--' == a", "x = [[--[=[]] == a", "--[==[ ]] ]==]\nx = a", "x = '\\\\' == a",
        "x = \"'\" == a", "-- '\nx = a", "x = a - -b"}) {
    EXPECT_NE(fault(begin + repeated(" or a", terms_max + 1)), "") << begin;
  }
}

TEST(SourceBudget, refuses_a_text_by_its_size) {
  EXPECT_EQ(fault(std::string(source_bytes_max, ' ')), "");
  EXPECT_THAT(fault(std::string(source_bytes_max + 1, ' ')), StartsWith("0: has "));
}

// Failure of compiling; "" for none.
std::string failure(const std::string& source, const Limits& limits = {}) {
  LuaState lua(make_api, limits);
  std::string message;
  lua.run([&](lua_State* L) {
    if (const auto failed = load_text(L, source, "a.lua")) message = failed->message;
  });
  return message;
}

TEST(SourceBudget, tells_where_a_text_is_nested_too_deeply) {
  EXPECT_THAT(failure("\n\nreturn " + repeated("(", 5000)),
              StartsWith("a.lua:3: is nested too deeply"));
  EXPECT_THAT(failure("local a =\n" + repeated("function() return\n", 500)),
              HasSubstr("is nested too deeply"));
  EXPECT_THAT(failure("return 1 +"), StartsWith("a.lua:1: unexpected symbol"));
  EXPECT_EQ(failure("return " + repeated("(", 100) + "1" + repeated(")", 100)), "");
}

// Constants that fall into one slot of the parser's hash table.
TEST(SourceBudget, stops_a_text_that_takes_too_long_in_another_way) {
  std::string source = "return {";
  for (std::uint64_t i = 1; i <= 50'000; ++i) {
    const std::uint64_t bits = 0x3ff0'0000'0000'0000 + i;
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    char text[32];
    std::snprintf(text, sizeof text, "%.17g,", value);
    source += text;
  }
  Limits limits;
  limits.compile_cpu_s = 0.2;
  EXPECT_THAT(failure(source + "}", limits),
              StartsWith("a.lua:1: takes more than 0.2 s of the processor's time to compile"));
}

}  // namespace
}  // namespace lsos
