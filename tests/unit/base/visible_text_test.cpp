#include "base/visible_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace lsos {
namespace {

TEST(VisibleText, leaves_ordinary_text_as_it_is) {
  for (const char* text :
       {"", "SEV1", "two lines\n\twith a tab", "Höhe 5 µm", "月面", "−5 °C", "🚙"}) {
    EXPECT_EQ(visible_text(text), text);
  }
}

TEST(VisibleText, shows_what_terminals_obey) {
  EXPECT_EQ(visible_text("\x1b]0;title\x07"), "\\u001b]0;title\\u0007");
  EXPECT_EQ(visible_text("a\rb\bc\x7f"), "a\\u000db\\u0008c\\u007f");
  EXPECT_EQ(visible_text(std::string_view("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(visible_text("\xc2\x9b"
                         "31m"),
            "\\u009b31m");  // CSI in one character
}

TEST(VisibleText, shows_what_is_not_seen) {
  EXPECT_EQ(visible_text("\u202e"
                         "txt.exe"),
            "\\u202etxt.exe");
  EXPECT_EQ(visible_text("\u2066x\u2069"), "\\u2066x\\u2069");
  EXPECT_EQ(visible_text("SEV\u200b1\ufeff"), "SEV\\u200b1\\ufeff");
  EXPECT_EQ(visible_text("\u2028"), "\\u2028");
  EXPECT_EQ(visible_text("\U000e0041"), "\\udb40\\udc41");
}

TEST(VisibleText, shows_bytes_that_are_no_utf8) {
  EXPECT_EQ(visible_text("\x9b"
                         "31m"),
            "\\x9b31m");
  EXPECT_EQ(visible_text("\xc3"), "\\xc3");
  EXPECT_EQ(visible_text("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(visible_text("\xc0\x9b"), "\\xc0\\x9b");                    // overlong
  EXPECT_EQ(visible_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
}

TEST(VisibleText, of_json_is_the_same_document) {
  std::string text;
  for (int code = 0; code < 0x80; ++code) text += static_cast<char>(code);
  text += "\u0085\u009b\u202e\u2066\u200b\ufeff\U000e0041 月";
  const nlohmann::json json{{"text", text}, {text, 1}};
  const std::string visible = visible_text(json.dump(2));
  EXPECT_EQ(nlohmann::json::parse(visible), json);
  EXPECT_EQ(visible_text(visible), visible);
}

TEST(XmlText, replaces_what_xml_does_not_allow) {
  EXPECT_EQ(xml_text("a\x1b\tb\n月"), "a\ufffd\tb\n月");
  EXPECT_EQ(xml_text("\xff\uffff<"), "\ufffd\ufffd<");
}

TEST(OneLine, has_blanks_for_control_characters) {
  EXPECT_EQ(one_line("A\nplan.kml:1: error"), "A plan.kml:1: error");
  EXPECT_TRUE(has_control_characters("A\rB"));
  EXPECT_FALSE(has_control_characters("Höhe"));
}

}  // namespace
}  // namespace lsos
