// The words of a condition, and what they stand for.
#pragma once

#include <string>
#include <vector>

namespace lsos {

struct ConditionWord {
  enum class Kind { name, text, number, symbol };
  Kind kind = Kind::symbol;
  std::string text;
};

// As Lua reads it, without comments. What is no Lua is told by Lua's own parser.
std::vector<ConditionWord> condition_words(const std::string& text);

// The text that the question at `i` is asked with: sees('B'), sees 'B'; nullptr: not a plain one.
const std::string* question_argument(const std::vector<ConditionWord>& words, std::size_t i);

}  // namespace lsos
