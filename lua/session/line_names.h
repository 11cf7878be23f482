// Names in a line that is typed at the prompt: of what it asks for, and of what it makes local.
#pragma once

#include <string>
#include <vector>

namespace lsos {

// The name that each expression of a list ends in, which says the unit of its value: "speed_mps",
// "x", "" of "sim.rovers.A.speed_mps, x[2], a / b". Of arithmetic it is ""; none of a line with
// functions, long texts or comments before its end, or of one that is very long.
std::vector<std::string> value_names(const std::string& line);

// Names that a line makes local: "x", "y" of "local x, y = 1, 2".
std::vector<std::string> local_names(const std::string& line);

}  // namespace lsos
