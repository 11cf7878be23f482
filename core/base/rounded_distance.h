// Distances as messages say them.
#pragma once

#include <string>

namespace lsos {

// To two digits: "480 m", "9.4 km", "94 km".
std::string rounded_distance(double distance_m);

}  // namespace lsos
