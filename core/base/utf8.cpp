#include "base/utf8.h"

#include <algorithm>

namespace lsos {

namespace {

// Bytes at the start that are ASCII other than zero: most texts are nothing else.
std::size_t ascii_length(std::string_view text) {
  const auto is_other = [](char c) { return static_cast<signed char>(c) <= 0; };
  return static_cast<std::size_t>(std::ranges::find_if(text, is_other) - text.begin());
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90)) return 0;  // overlong
  if ((first == 0xed && byte(1) > 0x9f) || (first == 0xf4 && byte(1) > 0x8f)) return 0;
  return length;
}

bool is_utf8(std::string_view text) {
  text.remove_prefix(ascii_length(text));
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

bool is_name(std::string_view text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
  return is_utf8(text) && std::ranges::none_of(text, is_control);
}

std::string beginning(std::string_view text, std::size_t bytes_max) {
  if (text.size() <= bytes_max) return std::string(text);
  const auto is_within_character = [&](std::size_t at) { return (text[at] & 0xc0) == 0x80; };
  constexpr std::size_t followers_max = 3;  // bytes of a character after its first
  std::size_t end = bytes_max;
  while (end > 0 && bytes_max - end < followers_max && is_within_character(end)) --end;
  return std::string(text.substr(0, end));
}

std::string utf8_text(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    const std::size_t plain = ascii_length(text);
    clean += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    const std::size_t length = text.front() == '\0' ? 0 : utf8_length(text);
    clean += length == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return clean;
}

}  // namespace lsos
