// Distances rounded for messages.
#pragma once

#include <string>

namespace lsos {

// Two significant digits, whole metres below 9.5 m: "480 m", "9.4 km", "94 km".
std::string rounded_distance(double distance_m);

}  // namespace lsos
