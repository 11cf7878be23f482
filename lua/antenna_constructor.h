// lsos.antenna, and the list of them in a rover.
#pragma once

#include <vector>

#include "lua/constructors.h"
#include "mission/antenna.h"

namespace lsos {

void read_antennas(TableReader& t, std::vector<AntennaSpec>& antennas);
std::vector<Constructor> antenna_constructors();

}  // namespace lsos
