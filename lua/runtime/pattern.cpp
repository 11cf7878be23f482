// After lstrlib.c of Lua 5.4; see pattern.h for its authors and licence.
#include "lua/runtime/pattern.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

namespace lsos {

namespace {

constexpr char escape = '%';
constexpr std::int64_t steps_unreported_max = 1024;

bool is_in_class(int c, int name) {
  bool is = false;
  switch (std::tolower(name)) {
    case 'a':
      is = std::isalpha(c) != 0;
      break;
    case 'c':
      is = std::iscntrl(c) != 0;
      break;
    case 'd':
      is = std::isdigit(c) != 0;
      break;
    case 'g':
      is = std::isgraph(c) != 0;
      break;
    case 'l':
      is = std::islower(c) != 0;
      break;
    case 'p':
      is = std::ispunct(c) != 0;
      break;
    case 's':
      is = std::isspace(c) != 0;
      break;
    case 'u':
      is = std::isupper(c) != 0;
      break;
    case 'w':
      is = std::isalnum(c) != 0;
      break;
    case 'x':
      is = std::isxdigit(c) != 0;
      break;
    case 'z':  // deprecated in Lua
      is = c == 0;
      break;
    default:
      return name == c;
  }
  return is != (std::isupper(name) != 0);
}

unsigned char byte(char c) { return static_cast<unsigned char>(c); }

}  // namespace

bool is_plain_pattern(std::string_view pattern) {
  return pattern.find_first_of("^$*+?.([%-") == std::string_view::npos;
}

PatternMatcher::PatternMatcher(std::string_view subject, std::string_view pattern, Counter counter)
    : s_begin_(subject.data()),
      s_end_(subject.data() + subject.size()),
      p_begin_(pattern.data()),
      p_end_(pattern.data() + pattern.size()),
      counter_(std::move(counter)) {}

void PatternMatcher::step(std::int64_t count) {
  steps_ += count;
  if (steps_ >= steps_unreported_max) report_steps();
}

void PatternMatcher::report_steps() {
  const std::int64_t steps = steps_;
  steps_ = 0;
  counter_(steps);
}

std::optional<std::size_t> PatternMatcher::match_at(std::size_t begin) {
  level_ = 0;
  depth_left_ = depth_max;
  const char* end = match(s_begin_ + begin, p_begin_);
  if (end == nullptr) return {};
  return static_cast<std::size_t>(end - s_begin_);
}

PatternMatcher::Capture PatternMatcher::capture(int number, std::size_t begin,
                                                std::size_t end) const {
  if (number >= level_) {
    if (number != 0) throw PatternError(fmt::format("invalid capture index %{}", number + 1));
    return {begin, end - begin};
  }
  const Part& part = parts_[static_cast<std::size_t>(number)];
  const auto from = static_cast<std::size_t>(part.begin - s_begin_);
  if (part.length == unfinished) throw PatternError("unfinished capture");
  if (part.length == position) return {from, {}};
  return {from, static_cast<std::size_t>(part.length)};
}

// Position past the single-character class that begins at `p`: c . %a [set].
const char* PatternMatcher::class_end(const char* p) {
  const char first = *p++;
  if (first == escape) {
    if (p == p_end_) throw PatternError("malformed pattern (ends with '%')");
    return p + 1;
  }
  if (first != '[') return p;
  const char* begin = p;
  if (pattern_at(p) == '^') ++p;
  do {  // a ']' at the beginning stands for itself
    if (p == p_end_) throw PatternError("malformed pattern (missing ']')");
    if (*p++ == escape && p < p_end_) ++p;
  } while (pattern_at(p) != ']');
  step(p - begin);
  return p + 1;
}

// `p` is at '[', `last` at ']'.
bool PatternMatcher::is_in_set(unsigned char c, const char* p, const char* last) {
  const char* begin = p;
  bool is_listed = false;
  const bool is_complement = p[1] == '^';
  if (is_complement) ++p;
  while (!is_listed && ++p < last) {
    if (*p == escape) {
      ++p;
      is_listed = is_in_class(c, byte(*p));
    } else if (p[1] == '-' && p + 2 < last) {
      p += 2;
      is_listed = byte(p[-2]) <= c && c <= byte(*p);
    } else {
      is_listed = byte(*p) == c;
    }
  }
  step(p - begin);
  return is_listed != is_complement;
}

bool PatternMatcher::matches_one(const char* s, const char* p, const char* end) {
  step();
  if (s >= s_end_) return false;
  const unsigned char c = byte(*s);
  switch (*p) {
    case '.':
      return true;
    case escape:
      return is_in_class(c, byte(p[1]));
    case '[':
      return is_in_set(c, p, end - 1);
    default:
      return byte(*p) == c;
  }
}

const char* PatternMatcher::match_balance(const char* s, const char* p) {
  if (p >= p_end_ - 1) throw PatternError("malformed pattern (missing arguments to '%b')");
  if (subject_at(s) != *p) return nullptr;
  const char open = *p, close = p[1];
  int depth = 1;
  while (++s < s_end_) {
    step();
    if (*s == close) {
      if (--depth == 0) return s + 1;
    } else if (*s == open) {
      ++depth;
    }
  }
  return nullptr;
}

const char* PatternMatcher::expand_most(const char* s, const char* p, const char* end) {
  std::ptrdiff_t count = 0;
  while (matches_one(s + count, p, end)) ++count;
  for (; count >= 0; --count) {
    if (const char* found = match(s + count, end + 1)) return found;
  }
  return nullptr;
}

const char* PatternMatcher::expand_least(const char* s, const char* p, const char* end) {
  for (;; ++s) {
    if (const char* found = match(s, end + 1)) return found;
    if (!matches_one(s, p, end)) return nullptr;
  }
}

const char* PatternMatcher::start_capture(const char* s, const char* p, std::ptrdiff_t what) {
  if (level_ >= captures_max) throw PatternError("too many captures");
  parts_[static_cast<std::size_t>(level_)] = {s, what};
  ++level_;
  const char* found = match(s, p);
  if (found == nullptr) --level_;
  return found;
}

const char* PatternMatcher::end_capture(const char* s, const char* p) {
  int open = level_ - 1;
  while (open >= 0 && parts_[static_cast<std::size_t>(open)].length != unfinished) --open;
  if (open < 0) throw PatternError("invalid pattern capture");
  Part& part = parts_[static_cast<std::size_t>(open)];
  part.length = s - part.begin;
  const char* found = match(s, p);
  if (found == nullptr) part.length = unfinished;
  return found;
}

const char* PatternMatcher::match_captured(const char* s, char digit) {
  const int number = digit - '1';
  if (number < 0 || number >= level_ ||
      parts_[static_cast<std::size_t>(number)].length == unfinished) {
    throw PatternError(fmt::format("invalid capture index %{}", number + 1));
  }
  const Part& part = parts_[static_cast<std::size_t>(number)];
  if (part.length == position || s_end_ - s < part.length) return nullptr;
  step(part.length / 8);
  const bool is_equal = std::memcmp(part.begin, s, static_cast<std::size_t>(part.length)) == 0;
  return is_equal ? s + part.length : nullptr;
}

// Matches the frontier %f[set], with `p` at the set: a position between a character outside it and
// one inside.
const char* PatternMatcher::match_frontier(const char* s, const char* p, const char*& next) {
  if (pattern_at(p) != '[') throw PatternError("missing '[' after '%f' in pattern");
  next = class_end(p);
  const char before = s == s_begin_ ? '\0' : s[-1];
  const bool is_frontier =
      !is_in_set(byte(before), p, next - 1) && is_in_set(byte(subject_at(s)), p, next - 1);
  return is_frontier ? s : nullptr;
}

// Matches a class with its suffix. `goes_on`: matching continues with the pattern at `next`, from
// the returned position of the subject.
const char* PatternMatcher::match_one(const char* s, const char* p, bool& goes_on,
                                      const char*& next) {
  const char* end = class_end(p);
  const char suffix = pattern_at(end);
  next = end + 1;
  if (!matches_one(s, p, end)) {
    goes_on = suffix == '*' || suffix == '?' || suffix == '-';
    return goes_on ? s : nullptr;
  }
  switch (suffix) {
    case '?':
      if (const char* found = match(s + 1, end + 1)) return found;
      goes_on = true;
      return s;
    case '+':
      return expand_most(s + 1, p, end);
    case '*':
      return expand_most(s, p, end);
    case '-':
      return expand_least(s, p, end);
    default:
      next = end;
      goes_on = true;
      return s + 1;
  }
}

const char* PatternMatcher::match(const char* s, const char* p) {
  if (depth_left_-- == 0) throw PatternError("pattern too complex");
  for (bool goes_on = true; goes_on && p != p_end_;) {
    step();
    goes_on = false;
    const char after = pattern_at(p + 1);
    if (*p == '(') {
      s = after == ')' ? start_capture(s, p + 2, position) : start_capture(s, p + 1, unfinished);
    } else if (*p == ')') {
      s = end_capture(s, p + 1);
    } else if (*p == '$' && p + 1 == p_end_) {
      if (s != s_end_) s = nullptr;
    } else if (*p == escape && after == 'b') {
      s = match_balance(s, p + 2);
      p += 4;
      goes_on = s != nullptr;
    } else if (*p == escape && after == 'f') {
      s = match_frontier(s, p + 2, p);
      goes_on = s != nullptr;
    } else if (*p == escape && std::isdigit(byte(after)) != 0) {
      s = match_captured(s, after);
      p += 2;
      goes_on = s != nullptr;
    } else {
      s = match_one(s, p, goes_on, p);
    }
  }
  ++depth_left_;
  return s;
}

}  // namespace lsos
