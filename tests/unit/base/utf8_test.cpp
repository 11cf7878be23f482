#include "base/utf8.h"

#include <gtest/gtest.h>

namespace lsos {
namespace {

TEST(Utf8, knows_well_formed_text) {
  for (const char* text : {"", "a", "\u00e4", "\u20ac", "\U0001f680", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
  }
  // A surrogate, overlong forms, beyond U+10FFFF, parts of a character.
  for (const char* text : {"\xed\xa0\x80", "\xc0\x9b", "\xe0\x80\x80", "\xf4\x90\x80\x80", "a\xc3",
                           "\x80", "\xe2\x82"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
  }
}

TEST(Utf8, cuts_before_a_character) {
  EXPECT_EQ(beginning("abc", 3), "abc");
  EXPECT_EQ(beginning("abc", 2), "ab");
  EXPECT_EQ(beginning("x\u00e4", 2), "x");
  EXPECT_EQ(beginning("x\u20ac", 3), "x");
  EXPECT_EQ(beginning("\U0001f680", 3), "");
  EXPECT_EQ(beginning("\x80\x80\x80\x80\x80\x80", 5).size(), 2u) << "no text at all";
}

TEST(Utf8, replaces_what_is_no_text) {
  EXPECT_EQ(utf8_text("S\u00e4v\U0001f680"), "S\u00e4v\U0001f680");
  EXPECT_EQ(utf8_text("na\xffme"), "na\ufffdme");
  EXPECT_EQ(utf8_text(std::string_view("a\0b", 3)), "a\ufffdb");
  EXPECT_EQ(utf8_text("x\xc3"), "x\ufffd");
}

TEST(Utf8, knows_names) {
  EXPECT_TRUE(is_name("S\u00e4v 1"));
  for (const char* name : {"two\nlines", "\x1b[2J", "x\x7f", "na\xffme"}) {
    EXPECT_FALSE(is_name(name)) << name;
  }
}

}  // namespace
}  // namespace lsos
