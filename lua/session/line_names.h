// Names in a line typed at the prompt: those of the expressions it evaluates, and those of its
// local variables.
#pragma once

#include <string>
#include <vector>

namespace lsos {

// For each expression of a list, the name that it ends in, which states the unit of its value:
// "speed_mps", "x", "" for "sim.rovers.A.speed_mps, x[2], a / b". Arithmetic gives "". A line with
// functions, long texts or comments before its end, or a very long line, is not read and gives one
// "".
std::vector<std::string> value_names(const std::string& line);

// Names of the local variables that a line declares: "x", "y" for "local x, y = 1, 2".
std::vector<std::string> local_names(const std::string& line);

}  // namespace lsos
