// Comparisons of a quantity alone with a number alone, as conditions are made of.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lua/host/condition_words.h"

namespace lsos {

// What a quantity can be; infinite where nothing bounds it.
struct Bounds {
  double low, high;
};

// A quantity on the left of a number.
struct Comparison {
  std::string quantity;  // "charge", "distance_to('Base')"
  std::string shown;     // the same, or math.abs of it
  std::string how;       // <, <=, >, >=, == or ~=
  double number = 0;
  Bounds bounds;         // of what is shown
  bool is_size = false;  // math.abs of the quantity is compared
  std::size_t end = 0;   // the word behind it
};

// What binds an operand of a comparison to nothing else before it, or after it.
bool begins_operand(const ConditionWord& before);
bool ends_operand(const ConditionWord& after);

// The comparison that begins with the word at `at`; none where more than a quantity and a number,
// or less, is compared there.
std::optional<Comparison> comparison_at(const std::vector<ConditionWord>& words, std::size_t at);
// All of them.
std::vector<Comparison> comparisons_of(const std::vector<ConditionWord>& words);

}  // namespace lsos
