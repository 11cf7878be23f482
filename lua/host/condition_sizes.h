// Finds comparisons whose number shows that another unit was meant, or that never hold.
#pragma once

#include <string>
#include <vector>

#include "lua/host/condition_words.h"
#include "lua/host/condition_world.h"

namespace lsos {

// Fault of a number that can only be in another unit, compared with a single quantity, its negative
// or its math.abs; "" for none.
std::string sizes_fault(const std::vector<ConditionWord>& words);
// Doubt about a number that is likely to be a mistake, or about a comparison that never holds; ""
// for none.
std::string sizes_doubt(const std::vector<ConditionWord>& words, const ConditionWorld& world);

}  // namespace lsos
