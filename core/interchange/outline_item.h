// One item of an outline: "08:00 drive to Ridge at 5 km/h".
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parsed.h"
#include "plan/declaration.h"

namespace lsos {

// Columns and their texts.
using OutlineFields = std::vector<std::pair<std::string, std::string>>;

// The event that an item states, with the columns Type, StartTime, Place and its fields.
Parsed<OutlineFields> parse_item(std::string_view item, const Declarations& declarations);

// The events that the words of an item begin, "PathPlanRoute" and "Route" for "drive", each once.
std::vector<std::string> events_said(std::string_view words, const Declarations& declarations);

// Adds what the parts after a comma state: "Speed 5 km/h", "as Ridge".
// Returns why one is not understood, else "".
std::string add_fields(const std::vector<std::string>& parts, std::size_t first,
                       const std::string& type, const Declarations& declarations,
                       OutlineFields& fields);

// Splits a text at each `separator` outside quotes and brackets; the parts are trimmed.
std::vector<std::string> split_outside(std::string_view text, char separator);
// A place as in "at Ridge > Base" or "at (30.1, -89.9)", for the column Place.
std::string place_text(std::string_view text);
// The text without its quotes, in which "" stands for a quote.
std::string unquoted(std::string_view text);
std::string in_quotes(const std::string& text);

}  // namespace lsos
