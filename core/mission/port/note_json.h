// JSON of numbers and texts in the fields of a note.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "base/utf8.h"

namespace lsos {

inline std::string note_json(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
}

// Bytes that are not UTF-8 become U+FFFD, so that the note is valid JSON.
inline std::string note_json(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t bytes = utf8_length(std::string_view(text).substr(at));
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
