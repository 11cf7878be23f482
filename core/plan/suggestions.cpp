#include "plan/suggestions.h"

#include <fmt/format.h>

#include <charconv>

#include "base/error.h"

namespace lsos {

std::string Suggestions::operator()(const std::string& name) {
  constexpr std::size_t max_answers = 20;
  constexpr std::size_t longest_name = 100;
  const auto answered = answers_.find(name);
  if (answered != answers_.end()) return answered->second;
  if (answers_.size() >= max_answers || name.size() > longest_name) return {};
  return answers_[name] = did_you_mean(name, known_);
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t max_names = 30;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < max_names; ++i) {
    list += fmt::format("{}{}", i == 0 ? "" : ", ", names[i]);
  }
  if (names.size() > max_names) list += fmt::format(", ... ({} in all)", names.size());
  return list;
}

std::string line_text(const Place& place, const std::string& file) {
  // A feature of a layer has a number instead of a line.
  if (place.file.find(".gpkg/") != std::string::npos) {
    return fmt::format("{}:{}", place.file, place.line);
  }
  if (place.file == file) return fmt::format("line {}", place.line);
  return fmt::format("line {} of {}", place.line, place.file);
}

std::string quoted(const std::string& text) {
  constexpr std::size_t longest = 80;
  std::string line = text.substr(0, longest);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  // A cut must not leave part of a UTF-8 character, so the bytes of an incomplete one are removed.
  if (line.size() < text.size() && (text[line.size()] & 0xc0) == 0x80) {
    while (!line.empty() && (line.back() & 0xc0) == 0x80) line.pop_back();
    if (!line.empty()) line.pop_back();
  }
  return fmt::format("'{}{}'", line, line.size() < text.size() ? "..." : "");
}

std::string shown(const std::string& text) {
  double number = 0;
  const char* const text_end = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), text_end, number);
  const bool is_number = error == std::errc{} && end == text_end && text.size() < 40;
  return is_number ? text : quoted(text);
}

}  // namespace lsos
