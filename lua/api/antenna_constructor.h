// The constructor lsos.antenna, and the list of antennas in a rover's table.
#pragma once

#include <vector>

#include "lua/api/constructors.h"
#include "mission/model/antenna.h"

namespace lsos {

void read_antennas(TableReader& t, std::vector<AntennaSpec>& antennas);
std::vector<Constructor> antenna_constructors();

}  // namespace lsos
