// Units of length as rasters name them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lsos {

// Metres a unit: "m", "Metre", "us-ft", ...; nullopt for anything that is no unit of length.
std::optional<double> length_unit_m(std::string_view name);
// Says nothing: "", "unknown", "none", ...
bool is_no_unit(std::string_view name);
// One name of each, for messages.
std::vector<std::string> length_unit_names();

}  // namespace lsos
