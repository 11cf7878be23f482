#include "lua/pattern_cost.h"

#include <cmath>

namespace lsos {

namespace {

// Past the single-character class that begins at `i`: c . %a [set].
std::size_t class_end(std::string_view pattern, std::size_t i) {
  if (pattern[i] == '%') return i + 2;
  if (pattern[i] != '[') return i + 1;
  ++i;
  if (i < pattern.size() && pattern[i] == '^') ++i;
  bool is_first = true;  // a ']' there stands for itself
  while (i < pattern.size() && (pattern[i] != ']' || is_first)) {
    i += pattern[i] == '%' ? 2 : 1;
    is_first = false;
  }
  return i + 1;
}

int exponent(std::string_view pattern) {
  return pattern_repetitions(pattern) + (pattern.starts_with('^') ? 0 : 1);
}

}  // namespace

int pattern_repetitions(std::string_view pattern) {
  int repetitions = 0;
  for (std::size_t i = pattern.starts_with('^') ? 1 : 0; i < pattern.size();) {
    if (pattern.substr(i).starts_with("%b")) {
      ++repetitions;
      i += 4;
      continue;
    }
    if (pattern[i] == '(' || pattern[i] == ')') {
      ++i;
      continue;
    }
    i = class_end(pattern, i);
    if (i < pattern.size() && std::string_view("*+-").find(pattern[i]) != std::string_view::npos) {
      ++repetitions;
      ++i;
    }
  }
  return repetitions;
}

double pattern_steps(std::string_view pattern, std::size_t subject_bytes) {
  return std::pow(static_cast<double>(subject_bytes), exponent(pattern));
}

double subject_bytes_max(std::string_view pattern) {
  const int power = exponent(pattern);
  return power == 0 ? pattern_steps_max : std::floor(std::pow(pattern_steps_max, 1.0 / power));
}

}  // namespace lsos
