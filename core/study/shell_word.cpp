#include "study/shell_word.h"

#include <algorithm>

#include "base/replaced.h"

namespace lsos {

namespace {

bool is_plain(char c) {
  constexpr std::string_view others = "_-./,:=@%+";
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || others.find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_word(std::string_view text) {
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return std::string(text);
  return "'" + replaced(std::string(text), "'", R"('\'')") + "'";
}

std::string shell_command(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) {
    if (!command.empty()) command += ' ';
    command += shell_word(word);
  }
  return command;
}

}  // namespace lsos
