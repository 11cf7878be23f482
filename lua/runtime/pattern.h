// Lua's text patterns on plain text, with each step of the matcher counted. The matcher backtracks,
// so that a short pattern can take longer than any mission; the caller must be able to stop it.
//
// A port of the matcher in lstrlib.c of Lua 5.4, Copyright (C) 1994-2022 Lua.org, PUC-Rio, by
// Roberto Ierusalimschy, Luiz Henrique de Figueiredo and Waldemar Celes, under the MIT licence:
// https://www.lua.org/license.html. It finds, captures and refuses the same as that matcher.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace lsos {

// Error in a pattern, in Lua's words: "malformed pattern (missing ']')".
class PatternError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class PatternMatcher {
 public:
  // Called at intervals with the number of steps since the last call; may throw, to stop.
  using Counter = std::function<void(std::int64_t steps)>;

  // `pattern` has no anchor at its beginning; both texts must outlive this object.
  PatternMatcher(std::string_view subject, std::string_view pattern, Counter counter);

  // End of the match that begins at `begin`; absent where the pattern does not match there. Throws
  // PatternError.
  std::optional<std::size_t> match_at(std::size_t begin);
  // Reports the remaining steps to the counter.
  void report_steps();

  // Number of captures of the last match.
  int capture_count() const { return level_; }
  struct Capture {
    std::size_t begin = 0;
    std::optional<std::size_t> length;  // absent: the position itself was captured
  };
  // Capture `number`, from 0. Without captures in the pattern, number 0 is the whole match
  // begin..end. Throws PatternError.
  Capture capture(int number, std::size_t begin, std::size_t end) const;

 private:
  static constexpr int captures_max = 32, depth_max = 200;
  static constexpr std::ptrdiff_t unfinished = -1, position = -2;
  struct Part {
    const char* begin = nullptr;
    std::ptrdiff_t length = unfinished;
  };

  void step(std::int64_t count = 1);
  char subject_at(const char* s) const { return s < s_end_ ? *s : '\0'; }
  char pattern_at(const char* p) const { return p < p_end_ ? *p : '\0'; }
  const char* match(const char* s, const char* p);
  const char* match_one(const char* s, const char* p, bool& goes_on, const char*& next);
  const char* match_frontier(const char* s, const char* p, const char*& next);
  const char* class_end(const char* p);
  bool is_in_set(unsigned char c, const char* p, const char* last);
  bool matches_one(const char* s, const char* p, const char* end);
  const char* match_balance(const char* s, const char* p);
  const char* expand_most(const char* s, const char* p, const char* end);
  const char* expand_least(const char* s, const char* p, const char* end);
  const char* start_capture(const char* s, const char* p, std::ptrdiff_t what);
  const char* end_capture(const char* s, const char* p);
  const char* match_captured(const char* s, char digit);

  const char *s_begin_, *s_end_, *p_begin_, *p_end_;
  Counter counter_;
  std::int64_t steps_ = 0;
  int depth_left_ = depth_max;
  int level_ = 0;
  std::array<Part, captures_max> parts_;
};

// Whether no character of the pattern has a special meaning.
bool is_plain_pattern(std::string_view pattern);

}  // namespace lsos
