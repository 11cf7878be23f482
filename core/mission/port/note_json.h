// JSON of numbers and texts in the fields of a note.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

namespace lsos {

inline std::string note_json(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
}

// Bytes of the UTF-8 character that begins at `at`; 0 when none does.
inline std::size_t utf8_bytes(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t count = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + count > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + count; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(at + 1);
  const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_no_character = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return is_overlong || is_no_character ? 0 : count;
}

// Bytes that are not UTF-8 become U+FFFD, so that the note is valid JSON.
inline std::string note_json(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t bytes = utf8_bytes(text, at);
    if (bytes != 1) {
      quoted += bytes == 0 ? "\xEF\xBF\xBD" : text.substr(at, bytes);
      if (bytes > 1) at += bytes - 1;
      continue;
    }
    const char c = text[at];
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) < ' ') {
      quoted += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace lsos
