// Numbers and texts in the fields of a note.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace lsos {

inline std::string note_json(double value) {
  return std::isnan(value) ? "null" : fmt::format("{:.6g}", value);
}

inline std::string note_json(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
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
