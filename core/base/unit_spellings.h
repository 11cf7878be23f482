// Everyday words for units, and units that are not read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lsos {

// One `word` is `factor` of the unit `symbol`.
struct UnitSpelling {
  std::string symbol;
  double factor = 1;
};

// "hrs" is h, "mph" is 1.609344 km/h, "KWH" is kWh; absent where no unit of the kind is meant for
// sure. An M that may be milli or mega is never guessed.
std::optional<UnitSpelling> spelled_unit(std::string_view word, std::string_view kind);

}  // namespace lsos
