// Texts in Lua source.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

// 'it\'s' for it's: the text as a literal in single quotes.
inline std::string lua_text(std::string_view text) {
  std::string literal = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') literal += '\\';
    literal += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return literal + "'";
}

}  // namespace lsos
