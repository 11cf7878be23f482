// Conditions that hold never, or always, for what their comparisons ask of one quantity.
#pragma once

#include <string>
#include <vector>

#include "lua/host/condition_words.h"

namespace lsos {

// A part of the condition that holds for no value of a quantity, as `charge < 0.2 and charge >
// 0.5`, or the whole of one that holds for all, as `charge > 0.2 or charge < 0.5`; "" when well.
std::string sets_doubt(const std::vector<ConditionWord>& words);

}  // namespace lsos
