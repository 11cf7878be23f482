// string.find, match, gmatch and gsub as in Lua 5.4, on a matcher that charges its steps. Their
// structure follows lstrlib.c of Lua 5.4; see pattern.h for its authors and licence.
#include <fmt/format.h>

#include <cstring>
#include <string>
#include <string_view>

#include "lua/runtime/pattern.h"
#include "lua/runtime/sandbox.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

// Steps of the matcher that take about the time of one Lua instruction.
constexpr std::int64_t steps_per_instruction = 4;

constexpr std::size_t result_bytes_max = std::size_t{64} << 20;

PatternMatcher::Counter charge_steps(lua_State* L) {
  return [L](std::int64_t steps) { charge(L, 1 + steps / steps_per_instruction); };
}

// Start position from the optional argument, counted from 0.
std::size_t begin_argument(lua_State* L, int index, std::size_t size) {
  const lua_Integer begin = luaL_optinteger(L, index, 1);
  if (begin > 0) return static_cast<std::size_t>(begin) - 1;
  if (begin == 0 || begin < -static_cast<lua_Integer>(size)) return 0;
  return size - static_cast<std::size_t>(-begin);
}

void push_capture(lua_State* L, std::string_view subject, const PatternMatcher::Capture& capture) {
  if (!capture.length) return lua_pushinteger(L, static_cast<lua_Integer>(capture.begin) + 1);
  charge_bytes(L, *capture.length);
  lua_pushlstring(L, subject.data() + capture.begin, *capture.length);
}

// Pushes all captures; without captures, the whole match if `with_whole`.
int push_captures(lua_State* L, std::string_view subject, const PatternMatcher& matcher,
                  std::size_t begin, std::size_t end, bool with_whole) {
  const int count = matcher.capture_count() == 0 && with_whole ? 1 : matcher.capture_count();
  luaL_checkstack(L, count, "too many captures");
  for (int i = 0; i < count; ++i) push_capture(L, subject, matcher.capture(i, begin, end));
  return count;
}

int find_plain(lua_State* L, std::string_view subject, std::string_view text, std::size_t begin) {
  constexpr std::size_t bytes_per_instruction = 4;
  charge(L,
         static_cast<std::int64_t>((subject.size() - begin + text.size()) / bytes_per_instruction));
  // memmem is linear, which std::string_view::find is not.
  const void* found =
      ::memmem(subject.data() + begin, subject.size() - begin, text.data(), text.size());
  if (found == nullptr) {
    lua_pushnil(L);
    return 1;
  }
  const auto at = static_cast<lua_Integer>(static_cast<const char*>(found) - subject.data());
  lua_pushinteger(L, at + 1);
  lua_pushinteger(L, at + static_cast<lua_Integer>(text.size()));
  return 2;
}

template <bool is_find>
int find_or_match(lua_State* L) {
  const std::string_view subject = text_argument(L, 1);
  std::string_view pattern = text_argument(L, 2);
  const std::size_t first = begin_argument(L, 3, subject.size());
  if (first > subject.size()) {
    lua_pushnil(L);
    return 1;
  }
  charge_bytes(L, pattern.size());
  if (is_find && (lua_toboolean(L, 4) != 0 || is_plain_pattern(pattern))) {
    return find_plain(L, subject, pattern, first);
  }
  const bool is_anchored = pattern.starts_with('^');
  if (is_anchored) pattern.remove_prefix(1);
  PatternMatcher matcher(subject, pattern, charge_steps(L));
  for (std::size_t begin = first; begin <= subject.size(); ++begin) {
    const auto end = matcher.match_at(begin);
    if (end) {
      matcher.report_steps();
      if (!is_find) return push_captures(L, subject, matcher, begin, *end, true);
      lua_pushinteger(L, static_cast<lua_Integer>(begin) + 1);
      lua_pushinteger(L, static_cast<lua_Integer>(*end));
      return 2 + push_captures(L, subject, matcher, begin, *end, false);
    }
    if (is_anchored) break;
  }
  matcher.report_steps();
  lua_pushnil(L);
  return 1;
}

// Upvalues: the subject, the pattern, the next position, the end of the last match (-1: none).
int next_match(lua_State* L) {
  const std::string_view subject = text_argument(L, lua_upvalueindex(1));
  const auto first = static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(3)));
  const lua_Integer last_end = lua_tointeger(L, lua_upvalueindex(4));
  PatternMatcher matcher(subject, text_argument(L, lua_upvalueindex(2)), charge_steps(L));
  for (std::size_t begin = first; begin <= subject.size(); ++begin) {
    const auto end = matcher.match_at(begin);
    if (!end || static_cast<lua_Integer>(*end) == last_end) continue;
    matcher.report_steps();
    for (const int upvalue : {3, 4}) {
      lua_pushinteger(L, static_cast<lua_Integer>(*end));
      lua_replace(L, lua_upvalueindex(upvalue));
    }
    return push_captures(L, subject, matcher, begin, *end, true);
  }
  matcher.report_steps();
  return 0;
}

int gmatch(lua_State* L) {
  const std::string_view subject = text_argument(L, 1);
  text_argument(L, 2);
  const std::size_t first = std::min(begin_argument(L, 3, subject.size()), subject.size() + 1);
  lua_settop(L, 2);
  lua_pushinteger(L, static_cast<lua_Integer>(first));
  lua_pushinteger(L, -1);
  lua_pushcclosure(L, guard<next_match>, 4);
  return 1;
}

// One call of gsub; its arguments stay in place on the stack.
class Substitution {
 public:
  explicit Substitution(lua_State* state)
      : L_(state), subject_(text_argument(L_, 1)), pattern_(text_argument(L_, 2)) {}

  int run() {
    const int type = lua_type(L_, 3);
    const auto all = static_cast<lua_Integer>(subject_.size()) + 1;
    const lua_Integer count_max = luaL_optinteger(L_, 4, all);
    const bool is_known =
        type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE;
    luaL_argexpected(L_, is_known, 3, "string/function/table");
    const bool is_anchored = pattern_.starts_with('^');
    if (is_anchored) pattern_.remove_prefix(1);
    charge_bytes(L_, pattern_.size());
    PatternMatcher matcher(subject_, pattern_, charge_steps(L_));
    lua_Integer count = 0;
    std::size_t at = 0;
    std::optional<std::size_t> last_end;
    bool is_changed = false;
    while (count < count_max) {
      const auto end = matcher.match_at(at);
      if (end && end != last_end) {
        ++count;
        matcher.report_steps();
        is_changed |= add_value(matcher, at, *end, type);
        last_end = end;
        at = *end;
      } else if (at < subject_.size()) {
        result_ += subject_[at++];
      } else {
        break;
      }
      if (is_anchored) break;
    }
    matcher.report_steps();
    if (is_changed) {
      add(subject_.substr(at));
      lua_pushlstring(L_, result_.data(), result_.size());
    } else {
      lua_pushvalue(L_, 1);
    }
    lua_pushinteger(L_, count);
    return 2;
  }

 private:
  void add(std::string_view text) {
    charge_bytes(L_, text.size());
    if (result_.size() + text.size() > result_bytes_max) {
      throw std::runtime_error(
          fmt::format("string.gsub would make more than {} MiB", result_bytes_max >> 20));
    }
    result_ += text;
  }

  // Adds the replacement of the match. Returns false where the match itself is kept.
  bool add_value(const PatternMatcher& matcher, std::size_t begin, std::size_t end, int type) {
    if (type == LUA_TFUNCTION) {
      lua_pushvalue(L_, 3);
      const int count = push_captures(L_, subject_, matcher, begin, end, true);
      charge(L_, instructions_per_call);
      lua_call(L_, count, 1);
    } else if (type == LUA_TTABLE) {
      push_capture(L_, subject_, matcher.capture(0, begin, end));
      lua_gettable(L_, 3);
    } else {
      add_text(matcher, begin, end);
      return true;
    }
    const bool is_kept = lua_toboolean(L_, -1) == 0;
    if (is_kept) {
      add(subject_.substr(begin, end - begin));
    } else if (lua_isstring(L_, -1) != 0) {
      add(text_argument(L_, -1));
    } else {
      throw PatternError(fmt::format("invalid replacement value (a {})", luaL_typename(L_, -1)));
    }
    lua_pop(L_, 1);
    return !is_kept;
  }

  // Adds the text at argument 3, with %0..%9 and %% replaced.
  void add_text(const PatternMatcher& matcher, std::size_t begin, std::size_t end) {
    std::string_view text = text_argument(L_, 3);
    for (std::size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%')) {
      add(text.substr(0, at));
      const char what = at + 1 < text.size() ? text[at + 1] : '\0';
      if (what == '%') {
        add("%");
      } else if (what == '0') {
        add(subject_.substr(begin, end - begin));
      } else if (what >= '1' && what <= '9') {
        const auto capture = matcher.capture(what - '1', begin, end);
        add(capture.length ? subject_.substr(capture.begin, *capture.length)
                           : std::string_view(std::to_string(capture.begin + 1)));
      } else {
        throw PatternError("invalid use of '%' in replacement string");
      }
      charge(L_, 1);
      text.remove_prefix(at + 2);
    }
    add(text);
  }

  lua_State* L_;
  std::string_view subject_, pattern_;
  std::string result_;
};

int gsub(lua_State* L) { return Substitution(L).run(); }

}  // namespace

void replace_pattern_functions(lua_State* L) {
  constexpr luaL_Reg functions[] = {{"find", guard<find_or_match<true>>},
                                    {"match", guard<find_or_match<false>>},
                                    {"gmatch", guard<gmatch>},
                                    {"gsub", guard<gsub>},
                                    {nullptr, nullptr}};
  luaL_setfuncs(L, functions, 0);
}

}  // namespace lsos
