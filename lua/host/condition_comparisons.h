// Comparisons of a single quantity with a single number, from which conditions are usually built.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lua/host/condition_words.h"

namespace lsos {

// Possible values of a quantity; infinite where it is not bounded.
struct Bounds {
  double low, high;
};

// A comparison, turned so that the quantity is on the left.
struct SingleComparison {
  std::string quantity;  // "charge", "distance_to('Base')"
  std::string shown;     // the same, or math.abs of it
  std::string how;       // <, <=, >, >=, == or ~=
  double number = 0;
  Bounds bounds;              // of the value named in `shown`
  bool is_magnitude = false;  // math.abs of the quantity is compared
  std::size_t end = 0;        // index of the word behind the comparison
};

// Whether an operand of a comparison may begin after the word `before`, or end before `after`, so
// that no other operator binds to it.
bool begins_operand(const ConditionWord& before);
bool ends_operand(const ConditionWord& after);

// The comparison that begins with the word at `at`; none where anything but a single quantity and a
// single number is compared there.
std::optional<SingleComparison> comparison_at(const std::vector<ConditionWord>& words,
                                              std::size_t at);
// All comparisons of a condition.
std::vector<SingleComparison> comparisons_of(const std::vector<ConditionWord>& words);

}  // namespace lsos
