#include "lua/session/line_names.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <string_view>

#include "base/text.h"

namespace lsos {

namespace {

// Longest line that is read, bytes.
constexpr std::size_t read_max = 2000;

// Whether a member of a vec3 has the unit of the vec3.
bool is_of_a_vec3(const std::string& member) {
  return member == "x" || member == "y" || member == "z" || member == "length";
}

// Reads a line that Lua has already parsed: its brackets and quotes match.
class LineReader {
 public:
  explicit LineReader(std::string_view rest) : rest_(rest) {}

  std::vector<std::string> value_names() {
    std::vector<std::string> names;
    if (rest_.starts_with("return") && rest_.size() > 6 && !is_name_letter(rest_[6])) {
      rest_.remove_prefix(6);
    }
    do {
      std::string name = path_name();
      const bool is_path = is_at_end();
      names.push_back(is_path ? std::move(name) : "");
      while (!is_at_end()) skip_token();
    } while (take(','));
    return names;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) {
      rest_.remove_prefix(1);
    }
  }
  // The next character that is not blank; 0 behind the last.
  char next() {
    skip_blanks();
    return rest_.empty() ? '\0' : rest_.front();
  }
  bool take(char c) {
    if (next() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  // Whether an expression ends here.
  bool is_at_end() {
    const char c = next();
    return c == '\0' || c == ',' || c == ';' || rest_.starts_with("--");
  }

  std::string take_word() {
    skip_blanks();
    std::size_t size = 0;
    while (size < rest_.size() && is_name_letter(rest_[size])) ++size;
    std::string word(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return word;
  }

  std::string take_text() {
    const char quote = rest_.front();
    std::size_t end = 1;
    while (end < rest_.size() && rest_[end] != quote) end += rest_[end] == '\\' ? 2 : 1;
    std::string text(rest_.substr(1, end - 1));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return text;
  }

  // Skips a word, a text, a bracketed group, or one other character.
  void skip_token() {
    const char c = next();
    if (c == '\'' || c == '"') {
      take_text();
    } else if (is_name_letter(c)) {
      take_word();
    } else {
      rest_.remove_prefix(1);
      const char close = c == '(' ? ')' : c == '[' ? ']' : c == '{' ? '}' : '\0';
      if (close == '\0') return;
      while (next() != '\0' && next() != close) skip_token();
      take(close);
    }
  }

  // Last name of a path: "speed_mps" for -sim.rovers['A'].speed_mps; for a call, that of its
  // function. Stops at the first character that belongs to no such path.
  std::string path_name() {
    std::string name;
    take('-');
    if (next() == '(') {
      skip_token();
    } else {
      name = take_word();
    }
    for (;;) {
      const char c = next();
      if (c == '[') {
        const std::string key = text_key();
        if (!key.empty()) name = key;
        skip_token();
      } else if (c == '(' || c == '{' || c == '\'' || c == '"') {
        skip_token();
      } else if ((c == '.' && !rest_.starts_with("..")) || c == ':') {
        rest_.remove_prefix(1);
        const std::string member = take_word();
        if (!is_of_a_vec3(member)) name = member;
      } else {
        return name;
      }
    }
  }

  // "time_s" for ['time_s'].
  std::string text_key() const {
    LineReader inside(rest_.substr(1));
    const char quote = inside.next();
    if (quote != '\'' && quote != '"') return "";
    std::string text = inside.take_text();
    return inside.next() == ']' ? text : "";
  }

  std::string_view rest_;
};

}  // namespace

std::vector<std::string> value_names(const std::string& line) {
  // Constructs with commas of their own, in words or in long texts and comments, are not read.
  static const std::regex other(R"(\[=*\[|--.*\S.*\n|\bfunction\b|\S.*\breturn\b)");
  if (line.size() > read_max || std::regex_search(line, other)) return {""};
  return LineReader(line).value_names();
}

std::vector<std::string> local_names(const std::string& line) {
  if (line.size() > read_max) return {};
  static const std::regex statement(R"((?:^|[;\s])local\s+(?:function\s+)?([\w\s,<>]+))");
  static const std::regex word(R"([A-Za-z_]\w*)");
  std::vector<std::string> names;
  for (std::sregex_iterator at(line.begin(), line.end(), statement), end; at != end; ++at) {
    const std::string list = (*at)[1];
    for (std::sregex_iterator name(list.begin(), list.end(), word); name != end; ++name) {
      names.push_back(name->str());
    }
  }
  return names;
}

}  // namespace lsos
