// Numbers with units, as texts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/parsed.h"
#include "base/units.h"

namespace lsos {

// Reads "10", "10 km/h", "1.5h", "-3e2 m" in the C locale; a bare number is in `unit`. The answer
// is SI. Infinite and not-a-number values are refused. Durations also as ISO 8601 (PT1H30M, P2D).
Parsed<double> parse_quantity(std::string_view text, const Unit& unit);

// Reads a whole number.
Parsed<std::int64_t> parse_integer(std::string_view text);
// Reads true, false, 1, 0.
Parsed<bool> parse_boolean(std::string_view text);

// For people: value_si in `unit` with its symbol, shortest form that reads back equal: "2.5 km/h".
std::string format_quantity(double value_si, const Unit& unit);

}  // namespace lsos
