// Durations as ISO 8601 writes them.
#pragma once

#include <string_view>

#include "base/parsed.h"

namespace lsos {

// Seconds of "PT1H30M" or "P2D", a text that begins with P: ISO 8601-1:2019, 5.5.2, without years
// and months, which have no fixed length. The last part may have a fraction.
Parsed<double> parse_iso_duration(std::string_view text);

}  // namespace lsos
