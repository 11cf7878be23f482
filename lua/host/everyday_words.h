// Everyday words in conditions, and the logged quantities that are meant.
#pragma once

#include <string>

namespace lsos {

// "; did you mean 'charge' (of the battery, 0 to 1)?" for "battery"; "" for a word that could mean
// anything. A unit that is not the quantity's own, as in slope_deg, is told with its conversion.
std::string everyday_word_hint(const std::string& word);

}  // namespace lsos
