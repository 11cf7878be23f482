// Everyday spellings of units, and units that the program does not read itself.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lsos {

// One `word` equals `factor` times the unit `symbol`.
struct UnitSpelling {
  std::string symbol;
  double factor = 1;
};

// "hrs" is h, "mph" is 1.609344 km/h, "KWH" is kWh; absent where no unit of the kind is certainly
// meant. An M that may be milli or mega is never guessed.
std::optional<UnitSpelling> spelled_unit(std::string_view word, std::string_view kind);

}  // namespace lsos
