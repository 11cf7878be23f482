// Power from assets to the rovers that are plugged into them.
#pragma once

#include "mission/fleet/fleet_sunlight.h"

namespace lsos {

// Rovers are served in the order of their ids, each with what it uses and has room for. Sunlight on
// an asset's panels is evaluated while a rover takes power; `sunlight` may be nullptr when no asset
// has panels.
void share_power(Fleet& fleet, FleetSunlight* sunlight, const Moment& moment);

}  // namespace lsos
