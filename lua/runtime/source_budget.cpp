#include "lua/runtime/source_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"

namespace lsos {

namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

template <std::size_t count>
bool is_among(std::string_view word, const std::array<std::string_view, count>& words) {
  return std::ranges::find(words, word) != words.end();
}

// Splits a text into Lua's tokens (reference manual, 3.1). It ends early where a token is broken,
// since the parser goes no further either.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) {}

  enum class Kind { word, text, symbol };  // word: a name, a keyword or a number
  Kind kind = Kind::symbol;
  std::string_view token;  // a text is not told

  bool next() {
    if (!skip_space()) return false;
    const char c = text_[at_];
    if (is_name_letter(c) || (c == '.' && is_digit(ahead(1)))) return take_word();
    kind = Kind::text;
    if (c == '"' || c == '\'') return skip_quoted(c);
    if (c == '[' && (ahead(1) == '[' || ahead(1) == '=')) return skip_long();
    kind = Kind::symbol;
    static constexpr std::array<std::string_view, 5> pairs{"==", "<=", ">=", "~=", "::"};
    const std::string_view two = text_.substr(at_, 2);
    token = text_.substr(at_, is_among(two, pairs) ? 2 : 1);
    at_ += token.size();
    return true;
  }

  int line() const {
    const auto is_end = [](char c) { return c == '\n'; };
    return 1 + static_cast<int>(std::ranges::count_if(text_.substr(0, at_), is_end));
  }

 private:
  char ahead(std::size_t by) const { return at_ + by < text_.size() ? text_[at_ + by] : '\0'; }

  // Spaces and comments; false at the end.
  bool skip_space() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else if (text_.substr(at_, 2) == "--") {
        at_ += 2;
        if (begins_long()) {
          if (!skip_long()) return false;
        } else {
          while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
        }
      } else {
        return true;
      }
    }
    return false;
  }

  bool take_word() {
    const std::size_t begin = at_;
    const bool is_number = !std::isalpha(static_cast<unsigned char>(text_[at_])) && ahead(0) != '_';
    while (at_ < text_.size() && (is_name_letter(text_[at_]) || (is_number && text_[at_] == '.')))
      ++at_;
    kind = Kind::word;
    token = text_.substr(begin, at_ - begin);
    return true;
  }

  bool skip_quoted(char quote) {
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == quote) {
        ++at_;
        return true;
      }
      if (is_line_end(c)) return false;
      if (c != '\\') continue;
      ++at_;
      if (ahead(0) == 'z') {
        while (std::isspace(static_cast<unsigned char>(ahead(1))) != 0) ++at_;
      } else if (is_line_end(ahead(0)) && is_line_end(ahead(1)) && ahead(0) != ahead(1)) {
        ++at_;
      }
    }
    return false;
  }

  // Number of '=' in the bracket that opens at at_; absent where none opens.
  std::optional<std::size_t> level() const {
    if (ahead(0) != '[') return {};
    std::size_t equals = 0;
    while (ahead(1 + equals) == '=') ++equals;
    return ahead(1 + equals) == '[' ? std::optional(equals) : std::nullopt;
  }
  bool begins_long() const { return level().has_value(); }

  bool skip_long() {
    const auto equals = level();
    if (!equals) return false;
    const std::string close = "]" + std::string(*equals, '=') + "]";
    const std::size_t end = text_.find(close, at_ + *equals + 2);
    if (end == std::string_view::npos) return false;
    at_ = end + close.size();
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

// Counts of a text by the brackets and blocks that lie within each other.
class Counter {
 public:
  explicit Counter(std::string_view text) : tokens_(text) {}

  std::optional<SourceFault> fault() {
    while (levels_.size() < levels_max && tokens_.next()) {
      std::string what = tokens_.kind == Tokens::Kind::word     ? count_word(tokens_.token)
                         : tokens_.kind == Tokens::Kind::symbol ? count_symbol(tokens_.token)
                                                                : "";
      if (!what.empty()) return SourceFault{tokens_.line(), std::move(what)};
      if (tokens_.kind == Tokens::Kind::text) is_behind_operand_ = true;
    }
    return {};
  }

 private:
  static constexpr std::size_t levels_max = 1000;  // the parser refuses 200

  struct Level {
    int terms = 0;         // of the expression that it is in
    int branches = 0;      // of an 'if'
    bool is_part = false;  // brackets round a part of an expression
  };

  void open(bool is_part = false) { levels_.push_back({0, 0, is_part}); }
  void close() {
    if (levels_.size() == 1) return;
    const Level inner = levels_.back();
    levels_.pop_back();
    // The parser's list of what is in brackets becomes part of that around them.
    if (inner.is_part) levels_.back().terms += inner.terms;
  }
  std::string count_jump() {
    if (++jumps_ <= jumps_max) return "";
    return fmt::format("more than {} 'break', 'goto' and labels in one text", jumps_max);
  }

  std::string count_word(std::string_view word) {
    static constexpr std::array<std::string_view, 4> values{"nil", "true", "false", "not"};
    static constexpr std::array<std::string_view, 10> others{
        "else", "elseif", "for", "goto", "in", "local", "return", "then", "while", "break"};
    is_behind_operand_ = false;
    if (word == "and" || word == "or") {
      if (++levels_.back().terms <= terms_max) return "";
      return fmt::format(
          "more than {} 'and' and 'or' in one expression; a loop over a table has no such limit",
          terms_max);
    }
    if (word == "function") {
      open();
    } else if (word == "if" || word == "do" || word == "repeat") {
      levels_.back().terms = 0;
      open();
    } else if (word == "end" || word == "until") {
      close();
      if (word == "until") levels_.back().terms = 0;
    } else if (is_among(word, others)) {
      levels_.back().terms = 0;
      if (word == "goto" || word == "break") return count_jump();
      if (word == "elseif" && ++levels_.back().branches > terms_max) {
        return fmt::format("more than {} 'elseif' in one 'if'; a table has no such limit",
                           terms_max);
      }
    } else {
      is_behind_operand_ = !is_among(word, values);
    }
    return "";
  }

  std::string count_symbol(std::string_view symbol) {
    const bool was_behind_operand = is_behind_operand_;
    is_behind_operand_ = false;
    if (symbol == "::") {
      is_in_label_ = !is_in_label_;
      return is_in_label_ ? count_jump() : "";
    }
    if (symbol == "(") {
      open(!was_behind_operand);  // else those of a call
    } else if (symbol == "[" || symbol == "{") {
      open();
    } else if (symbol == ")" || symbol == "]" || symbol == "}") {
      close();
      is_behind_operand_ = true;
    } else if (symbol == "," || symbol == ";" || symbol == "=") {
      levels_.back().terms = 0;
    }
    return "";
  }

  Tokens tokens_;
  std::vector<Level> levels_{Level{}};
  int jumps_ = 0;
  bool is_in_label_ = false;
  bool is_behind_operand_ = false;  // of a name, a text or a closing bracket, which may be called
};

}  // namespace

std::optional<SourceFault> source_fault(std::string_view source) {
  if (source.size() > source_bytes_max) {
    return SourceFault{0, fmt::format("has {} KiB; a text of Lua may have {} KiB",
                                      source.size() >> 10, source_bytes_max >> 10)};
  }
  return Counter(source).fault();
}

}  // namespace lsos
