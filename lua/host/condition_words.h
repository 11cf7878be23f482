// Splits a condition into words.
#pragma once

#include <string>
#include <vector>

namespace lsos {

struct ConditionWord {
  enum class Kind { name, text, number, symbol };
  Kind kind = Kind::symbol;
  std::string text;
};

// Tokens as Lua reads them, without comments, except that each symbol is one character (== is two)
// and the sign of an exponent stands alone. Text that is not Lua is reported by Lua's own parser.
std::vector<ConditionWord> condition_words(const std::string& text);

// The argument of the question at `i`, as in sees('B') or sees 'B'; nullptr if it is no plain text.
const std::string* question_argument(const std::vector<ConditionWord>& words, std::size_t i);

// Whether the condition asks what a row of the log does not say: sees('SEV2').
bool has_question(const std::string& text);

}  // namespace lsos
