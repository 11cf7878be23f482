// Maps everyday words in conditions to the logged quantities that they mean.
#pragma once

#include <string>

namespace lsos {

// "; did you mean 'charge' (of the battery, 0 to 1)?" for "battery"; "" for a word that could mean
// anything. For a unit other than the quantity's own, as in slope_deg, the conversion is added.
std::string everyday_word_hint(const std::string& word);

}  // namespace lsos
