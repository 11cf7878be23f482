// How long Lua's pattern matcher could take. It backtracks: each repetition can multiply the work
// by the length of the text, and no count hook fires meanwhile.
#pragma once

#include <cstddef>
#include <string_view>

namespace lsos {

// About half a second.
inline constexpr double pattern_steps_max = 1e8;

// Items of the pattern that can match at every length: x* x+ x- %bxy.
int pattern_repetitions(std::string_view pattern);

// Upper bound of steps on a text of `subject_bytes`: n^(repetitions), times n for the start
// unless the pattern begins with '^'.
double pattern_steps(std::string_view pattern, std::size_t subject_bytes);

// The longest text on which the bound is not above pattern_steps_max.
double subject_bytes_max(std::string_view pattern);

}  // namespace lsos
