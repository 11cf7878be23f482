// Reads plans in NASA Ames' xPJSON format (xGDS), whose stations and segments alternate.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"

namespace lsos {

bool is_xpjson(const std::string& bytes);

// A Route for each segment, to the station after it, with its speed and tolerance; the stations as
// places by name and id; and commands that are called as an event is. `left_out` receives what has
// no counterpart, "SEG01_0_SPP: PeriodicPancam". The rover is called as the platform is. Throws
// InputError when the text is no xPJSON plan.
std::vector<Table> read_xpjson(const std::string& bytes, const std::string& file,
                               const std::vector<std::string>& events,
                               std::vector<std::string>& left_out);

}  // namespace lsos
