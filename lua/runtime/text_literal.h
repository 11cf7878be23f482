// Text literals in Lua source.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

// The text as a literal in single quotes: 'it\'s' for it's.
inline std::string lua_text(std::string_view text) {
  std::string literal = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') literal += '\\';
    literal += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return literal + "'";
}

}  // namespace lsos
