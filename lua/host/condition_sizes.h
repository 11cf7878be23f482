// Comparisons of a condition whose number shows that another unit was meant, or that never hold.
#pragma once

#include <string>
#include <vector>

#include "lua/host/condition_words.h"
#include "lua/host/condition_world.h"

namespace lsos {

// A number that can only be in another unit, beside a quantity alone, its negative or its math.abs;
// "" when well.
std::string sizes_fault(const std::vector<ConditionWord>& words);
// The same of numbers that are likely to be slips, and of comparisons that never hold.
std::string sizes_doubt(const std::vector<ConditionWord>& words, const ConditionWorld& world);

}  // namespace lsos
