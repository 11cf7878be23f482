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
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace lsos
