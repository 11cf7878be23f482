// Finds conditions that never hold, or always hold, because of their comparisons of one quantity.
#pragma once

#include <string>
#include <vector>

#include "lua/host/condition_words.h"

namespace lsos {

// Doubt about a part of the condition that holds for no value of a quantity, as `charge < 0.2 and
// charge > 0.5`, or about a condition that holds for all values, as `charge > 0.2 or charge < 0.5`;
// "" for none.
std::string sets_doubt(const std::vector<ConditionWord>& words);

}  // namespace lsos
