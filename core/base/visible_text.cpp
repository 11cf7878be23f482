#include "base/visible_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "base/utf8.h"

namespace lsos {

namespace {

std::uint32_t code_point(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0);
  std::uint32_t code = byte(0) & (0x7fU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (byte(i) & 0x3fU);
  return code;
}

struct Range {
  std::uint32_t first, last;
};

// Unicode's control and format characters, line and paragraph separators, and blanks without width
// (Unicode 15, categories Cc, Cf, Zl, Zp). Soft hyphens and variation selectors, which change how a
// neighbour looks, stay.
constexpr Range hidden[] = {
    {0x00, 0x08},       {0x0b, 0x1f},       {0x7f, 0x9f},      {0x034f, 0x034f}, {0x061c, 0x061c},
    {0x115f, 0x1160},   {0x17b4, 0x17b5},   {0x180e, 0x180e},  {0x200b, 0x200f}, {0x2028, 0x202e},
    {0x2060, 0x206f},   {0x3164, 0x3164},   {0xfeff, 0xfeff},  {0xffa0, 0xffa0}, {0xfff9, 0xfffb},
    {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe007f}};

bool is_hidden(std::uint32_t code) {
  return std::ranges::any_of(
      hidden, [&](const Range& range) { return code >= range.first && code <= range.last; });
}

// As JSON writes it, beyond U+FFFF in two halves.
void append_escaped(std::string& text, std::uint32_t code) {
  const auto out = std::back_inserter(text);
  if (code < 0x10000) {
    fmt::format_to(out, "\\u{:04x}", code);
  } else {
    const std::uint32_t offset = code - 0x10000;
    fmt::format_to(out, "\\u{:04x}\\u{:04x}", 0xd800 + (offset >> 10), 0xdc00 + (offset & 0x3ff));
  }
}

// The end of the characters at the start that any terminal shows as they are.
std::size_t plain_length(std::string_view text) {
  const auto is_special = [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') ||
           static_cast<unsigned char>(c) >= 0x7f;
  };
  return static_cast<std::size_t>(std::ranges::find_if(text, is_special) - text.begin());
}

// Length of the character at the start of `text` that XML 1.0 allows; 0: none.
std::size_t xml_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x20 && first != '\t' && first != '\n' && first != '\r') return 0;
  const bool is_noncharacter = text.starts_with("\xef\xbf\xbe") || text.starts_with("\xef\xbf\xbf");
  return is_noncharacter ? 0 : utf8_length(text);
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string visible_text(std::string_view text) {
  std::string visible;
  visible.reserve(text.size());
  while (!text.empty()) {
    const std::size_t plain = plain_length(text);
    visible += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(1, length));
    if (length == 0) {
      fmt::format_to(std::back_inserter(visible), "\\x{:02x}",
                     static_cast<unsigned char>(text.front()));
    } else if (const std::uint32_t code = code_point(character); is_hidden(code)) {
      append_escaped(visible, code);
    } else {
      visible += character;
    }
    text.remove_prefix(character.size());
  }
  return visible;
}

std::string xml_text(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = xml_length(text);
    clean += length == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(1, utf8_length(text)));
  }
  return clean;
}

std::string one_line(std::string_view text) {
  std::string line(text);
  std::ranges::replace_if(line, is_control, ' ');
  return line;
}

bool has_control_characters(std::string_view text) { return std::ranges::any_of(text, is_control); }

}  // namespace lsos
