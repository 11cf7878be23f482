// Units of length as rasters name them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lsos {

// Metres per unit: "m", "Metre", "us-ft", ...; nullopt for anything that is no unit of length.
std::optional<double> length_unit_m(std::string_view name);
// Whether the name states no unit: "", "unknown", "none", ...
bool is_no_unit(std::string_view name);
// One name of each unit, for messages.
std::vector<std::string> length_unit_names();

}  // namespace lsos
