// Suggestions for a quantity that cannot be read: other spellings of units and numbers.
#pragma once

#include <string>
#include <string_view>

#include "base/units.h"

namespace lsos {

// "; did you mean 'h'?" for "2 hrs" where a duration is wanted, "; did you mean '8.04672 km/h'?"
// for "5 mph"; "" where the meaning is not certain. A suggestion has the wanted kind and the size
// that was written.
std::string quantity_advice(std::string_view text, const Unit& wanted);

// The same for a unit alone; an empty `kind` allows any.
std::string unit_advice(std::string_view symbol, std::string_view kind = "");

// The same for a whole number: "; did you mean '1500'?" for "1,500", and "10" for "10.0".
std::string whole_number_advice(std::string_view text);

}  // namespace lsos
