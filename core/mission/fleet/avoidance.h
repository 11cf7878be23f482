// Rovers do not touch each other or an asset: places that overlap are refused, and drives end in
// time.
#pragma once

#include "mission/fleet/fleet.h"

namespace lsos {

// Errors for rovers that are placed where another or an asset stands.
std::vector<Fault> overlapping_rovers(const Fleet& fleet, const MissionMachine& machine);

// Ends the drives of two rovers that could not stop before each other, or of which one would turn
// into the other, if the motion of one brings it nearer. One that leaves the other drives on.
void avoid_rovers(Fleet& fleet);
// The same for assets, which do not move.
void avoid_assets(Fleet& fleet);

}  // namespace lsos
