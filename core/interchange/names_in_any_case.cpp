#include "interchange/names_in_any_case.h"

#include <algorithm>
#include <cctype>

namespace lsos {

std::string name_in_any_case(const std::string& text, const std::vector<std::string>& names) {
  if (std::ranges::find(names, text) != names.end()) return text;
  const auto small = [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  };
  std::string found;
  for (const std::string& name : names) {
    if (!std::ranges::equal(text, name, {}, small, small) || name == found) continue;
    if (!found.empty()) return "";
    found = name;
  }
  return found;
}

}  // namespace lsos
