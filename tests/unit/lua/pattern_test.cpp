// Text patterns compared with Lua's own: the same results, the same errors.
#include "lua/runtime/pattern.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <lua.hpp>
#include <memory>
#include <random>
#include <string>

#include "lua/api/api.h"
#include "lua/runtime/environment.h"
#include "lua/runtime/state.h"

namespace lsos {
namespace {

std::string quoted(const std::string& text) {
  std::string literal = "'";
  for (const char c : text) literal += fmt::format("\\{:03}", static_cast<unsigned char>(c));
  return literal + "'";
}

// A chunk that calls every pattern function on a subject and returns all results as one text.
std::string chunk(const std::string& subject, const std::string& pattern,
                  const std::string& replacement, int begin, int count) {
  return fmt::format(
      R"(
local s, p, r, init, n = {}, {}, {}, {}, {}
local out = {{}}
local function add(v) out[#out + 1] = type(v) .. ':' .. tostring(v) end
local function show(...)
  for i = 1, select('#', ...) do add((select(i, ...))) end
  out[#out + 1] = '|'
end
show(pcall(string.find, s, p))
show(pcall(string.find, s, p, init))
show(pcall(string.find, s, p, init, true))
show(pcall(string.match, s, p))
show(pcall(string.match, s, p, init))
for _, from in ipairs {{ 1, init }} do
  show(pcall(function() for a, b in string.gmatch(s, p, from) do show(a, b) end end))
end
show(pcall(string.gsub, s, p, r))
show(pcall(string.gsub, s, p, r, n))
show(pcall(string.gsub, s, p, {{ a = 'x', b = 2, ab = false, [1] = 'first', [''] = 'e' }}))
show(pcall(string.gsub, s, p, function(a, b) if a == 'b' then return nil end
  return '<' .. tostring(a) .. tostring(b) .. '>' end))
return table.concat(out, ' '))",
      quoted(subject), quoted(pattern), quoted(replacement), begin, count);
}

class Pattern : public ::testing::Test {
 protected:
  Pattern() : stock_(luaL_newstate(), lua_close) { luaL_openlibs(stock_.get()); }

  std::string of_stock(const std::string& text) {
    lua_State* L = stock_.get();
    const bool is_well = luaL_loadbuffer(L, text.data(), text.size(), "=chunk") == LUA_OK &&
                         lua_pcall(L, 0, 1, 0) == LUA_OK;
    return (is_well ? "" : "FAILED ") + taken(L);
  }
  std::string of_ours(const std::string& text) {
    std::string result;
    ours_.run([&](lua_State* L) {
      if (const auto failure = load_text(L, text, "chunk")) FAIL() << failure->message;
      push_environment(L);
      lua_setupvalue(L, -2, 1);
      if (const auto failure = call_script(L, 0, 1)) FAIL() << failure->message;
      result = taken(L);
    });
    return result;
  }
  void expect_equal(const std::string& subject, const std::string& pattern,
                    const std::string& replacement = "<%0%1>", int begin = 2, int count = 2) {
    const std::string text = chunk(subject, pattern, replacement, begin, count);
    // Errors differ only in their place, "chunk:12: " and the like.
    ASSERT_EQ(of_ours(text), of_stock(text))
        << "subject '" << subject << "' pattern '" << pattern << "' replacement '" << replacement
        << "' begin " << begin << " count " << count;
  }

 private:
  static std::string taken(lua_State* L) {
    std::size_t size = 0;
    const char* bytes = lua_tolstring(L, -1, &size);
    std::string text = bytes == nullptr ? "no text" : std::string(bytes, size);
    lua_pop(L, 1);
    return text;
  }

  std::unique_ptr<lua_State, void (*)(lua_State*)> stock_;
  LuaState ours_{make_api};
};

TEST_F(Pattern, tricky_cases_are_as_in_lua) {
  const std::string zero("a\0b\0", 4);
  const std::vector<std::string> patterns{
      "",       "^",      "$",         "^$",           "a",        "^a",          "a$",
      "a$b",    "^^a",    "()",        "(())",         "(a)(b)()", "((a)(b))",    "(a",
      "a)",     "(()",    "%",         "a%",           "%%",       "[",           "[a",
      "[]",     "[]]",    "[^]]",      "[^",           "[]a]",     "[a-c]",       "[a-]",
      "[-a]",   "[%a-z]", "[%]",       "[%]]",         "[^%s]",    "[a-%%]",      "a*",
      "a+",     "a-",     "a?",        "a-b",          ".-",       ".-b",         ".*b",
      ".+",     "(.-)b",  "^(.-)%s*$", "%b()",         "%b",       "%b(",         "%bxx",
      "%f",     "%f[",    "%f[%w]",    "%f[%w]%w+",    "%f[^%z]",  "%f[%z]",      "%1",
      "(a)%1",  "(a*)%1", "(a)%2",     "(a%1)",        "()%1",     "%0",          "%9",
      "[%w_]+", "%a+%d*", "%x+",       "%p",           "%S+",      "%W",          "%l%u",
      "%c",     "%g+",    "%z",        "[\x80-\xff]",  "*",        "+a",          "?",
      "-",      "a**",    "a*?",       "(a)(a)(a)(a)", "a?b?c?",   "(%w+)=(%w+)", "[[]",
      "[^^]",   "^*",     "%$",        "\n",           "$$",       "a^"};
  const std::vector<std::string> subjects{"",
                                          "a",
                                          "b",
                                          "aa",
                                          "ab",
                                          "aab",
                                          "abab",
                                          "aaa",
                                          "THE (quick) fox",
                                          "x = 12, yy=0x1F",
                                          "((a)(b(c)))",
                                          "[]]^-%",
                                          "a^b$c",
                                          zero,
                                          "\xff\x80 a",
                                          "  trim me  ",
                                          "hello\nworld"};
  for (const std::string& pattern : patterns) {
    for (const std::string& subject : subjects) expect_equal(subject, pattern);
  }
}

TEST_F(Pattern, replacements_and_beginnings_are_as_in_lua) {
  for (const char* replacement : {"", "x", "%0", "%1", "%2", "%%", "%", "%a", "a%", "%9", "%1%0"}) {
    for (const char* pattern : {"a", "(a)", "()a", "(a)(b)", "", "^a", "b*"}) {
      expect_equal("abcab", pattern, replacement);
    }
  }
  for (const int begin : {-100, -6, -5, -1, 0, 1, 5, 6, 7, 100}) {
    for (const char* pattern : {"a", "", "^a", "b()", ".*"})
      expect_equal("abcab", pattern, "x", begin);
  }
  for (const int count : {-1, 0, 1, 3, 100}) expect_equal("aaaa", "a*", "-", 1, count);
}

TEST_F(Pattern, too_many_captures_and_too_deep_patterns_are_as_in_lua) {
  std::string captures, depth, optional;
  for (int i = 0; i < 33; ++i) captures += "()";
  expect_equal("a", captures.substr(0, 64));
  expect_equal("a", captures);
  for (int i = 0; i < 250; ++i) optional += "a?";
  expect_equal("b", optional);
  expect_equal(std::string(300, 'a'), optional);
}

TEST_F(Pattern, random_ones_are_as_in_lua) {
  std::mt19937 random(20260722);
  const auto pick = [&](const auto& list) {
    return list[std::uniform_int_distribution<std::size_t>(0, std::size(list) - 1)(random)];
  };
  const std::vector<std::string> atoms{
      "a",      "b",     "c", ".",  "%a", "%d",  "%s",   "%w", "%A", "[ab]", "[^a]",
      "[a-c]",  "[%d_]", "(", ")",  "()", "(a)", "(.-)", "%1", "%2", "%b()", "%f[%a]",
      "%f[^a]", "$",     "^", "%%", "1",  " ",   "%",    "[",  "]"};
  const std::vector<std::string> suffixes{"", "", "", "", "*", "+", "-", "?"};
  const std::vector<std::string> letters{"a", "b", "c", "(", ")", "1",
                                         " ", "_", "%", "A", "^", "$"};
  const std::vector<std::string> replacements{"x", "%0", "<%1>", "%2", "", "%%", "%"};
  for (int i = 0; i < 6000; ++i) {
    std::string subject, pattern;
    const int length = std::uniform_int_distribution(0, 14)(random);
    for (int k = 0; k < length; ++k) subject += pick(letters);
    const int parts = std::uniform_int_distribution(1, 5)(random);
    for (int k = 0; k < parts; ++k) pattern += pick(atoms) + pick(suffixes);
    expect_equal(subject, pattern, pick(replacements),
                 std::uniform_int_distribution(-16, 16)(random),
                 std::uniform_int_distribution(0, 4)(random));
    if (HasFatalFailure()) return;
  }
}

TEST(PatternMatcher, counts_its_steps) {
  std::int64_t steps = 0;
  const auto steps_of = [&](const std::string& subject, const std::string& pattern) {
    steps = 0;
    PatternMatcher matcher(subject, pattern, [&](std::int64_t more) { steps += more; });
    matcher.match_at(0);
    matcher.report_steps();
    return steps;
  };
  EXPECT_LT(steps_of("aaa", "a*"), 20);
  EXPECT_GT(steps_of(std::string(1000, 'a'), "a*b"), 1000);
  EXPECT_GT(steps_of("a", "[" + std::string(1000, 'b') + "a]"), 1000);
  EXPECT_GT(steps_of(std::string(20, 'a'), "a?a?a?a?a?a?a?a?a?a?a?a?aaaaaaaaaaaaaaaaaaaab"), 4000);
}

TEST(PatternMatcher, can_be_stopped) {
  struct Enough {};
  const std::string subject(40, 'a');
  std::string pattern;
  for (int i = 0; i < 40; ++i) pattern = "a?" + pattern + "a";
  std::int64_t steps = 0;
  pattern += "b";
  PatternMatcher matcher(subject, pattern, [&](std::int64_t more) {
    if ((steps += more) > 100'000) throw Enough();
  });
  EXPECT_THROW(matcher.match_at(0), Enough);
}

}  // namespace
}  // namespace lsos
