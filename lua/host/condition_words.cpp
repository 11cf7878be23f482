#include "lua/host/condition_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "lua/host/condition.h"

namespace lsos {

namespace {

// Position past the end of the long text [==[ ... ]==] that begins at `at`; absent where none
// begins.
std::optional<std::size_t> long_text_end(const std::string& text, std::size_t at,
                                         std::size_t& level) {
  level = text.find_first_not_of('=', at + 1);
  if (text[at] != '[' || level == std::string::npos || text[level] != '[') return {};
  level -= at + 1;
  const std::size_t end = text.find("]" + std::string(level, '=') + "]", at);
  return end == std::string::npos ? text.size() : end + level + 2;
}

}  // namespace

std::vector<ConditionWord> condition_words(const std::string& text) {
  std::vector<ConditionWord> words;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const std::size_t begin = i;
    std::size_t level = 0;
    if (text.compare(i, 2, "--") == 0) {
      const auto end =
          i + 2 < text.size() ? long_text_end(text, i + 2, level) : std::optional<std::size_t>();
      i = end ? *end : std::min(text.find('\n', i), text.size());
    } else if (c == '\'' || c == '"') {
      ++i;
      while (i < text.size() && text[i] != c) i += text[i] == '\\' ? 2 : 1;
      i = std::min(i, text.size());
      words.push_back({ConditionWord::Kind::text, text.substr(begin + 1, i - begin - 1)});
      ++i;
    } else if (const auto end = long_text_end(text, i, level)) {
      i = *end;
      const std::size_t edge = level + 2;
      words.push_back({ConditionWord::Kind::text, text.substr(begin + edge, i - begin - 2 * edge)});
    } else if (std::isdigit(static_cast<unsigned char>(c)) != 0 ||
               (c == '.' && i + 1 < text.size() &&
                std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0)) {
      while (i < text.size() && (is_name_letter(text[i]) || text[i] == '.')) ++i;
      words.push_back({ConditionWord::Kind::number, text.substr(begin, i - begin)});
    } else if (is_name_letter(c)) {
      while (i < text.size() && is_name_letter(text[i])) ++i;
      words.push_back({ConditionWord::Kind::name, text.substr(begin, i - begin)});
    } else {
      ++i;
      if (std::isspace(static_cast<unsigned char>(c)) == 0) {
        words.push_back({ConditionWord::Kind::symbol, {c}});
      }
    }
  }
  return words;
}

const std::string* question_argument(const std::vector<ConditionWord>& words, std::size_t i) {
  const std::size_t at = i + 1 < words.size() && words[i + 1].text == "(" &&
                                 words[i + 1].kind == ConditionWord::Kind::symbol
                             ? i + 2
                             : i + 1;
  return at < words.size() && words[at].kind == ConditionWord::Kind::text ? &words[at].text
                                                                          : nullptr;
}

namespace {

std::string number_literal(double value) {
  return std::isnan(value) ? "not known" : fmt::format("{:.4g}", value);
}

std::string answer_text(const std::string& question, const std::string& argument,
                        const RoverPort& rover) {
  if (question == "resource") {
    auto& port = const_cast<RoverPort&>(rover);  // only reads
    return number_literal(port.power().resource(argument).value_or(std::nan("")));
  }
  if (question == "distance_to") {
    const auto p_S_m = rover.place_of_S_m(argument);
    return number_literal(p_S_m ? (*p_S_m - rover.view().p_S_m).norm() : std::nan(""));
  }
  const auto sight = rover.sight_of(argument);
  const bool is_so = sight && (question == "sees" ? sight->is_visible : sight->is_linked);
  return is_so ? "true" : "false";
}

}  // namespace

std::string condition_values(const std::string& text, const SampleRow& row,
                             const RoverPort& rover) {
  std::vector<std::string> values;
  const std::vector<ConditionWord> words = condition_words(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].kind != ConditionWord::Kind::name) continue;
    std::string name = words[i].text, value;
    if (const std::string* argument = is_question(name) ? question_argument(words, i) : nullptr) {
      value = answer_text(name, *argument, rover);
      name += fmt::format("('{}')", *argument);
    } else if (const auto quantity = condition_quantity(name, row)) {
      value = number_literal(*quantity);
    } else {
      continue;
    }
    std::string said = fmt::format("{} was {}", name, value);
    if (std::ranges::find(values, said) == values.end()) values.push_back(std::move(said));
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

bool has_question(const std::string& text) {
  const std::vector<ConditionWord> words = condition_words(text);
  return std::ranges::any_of(words, [](const ConditionWord& word) {
    return word.kind == ConditionWord::Kind::name && is_question(word.text);
  });
}

}  // namespace lsos
