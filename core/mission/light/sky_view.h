// Directions of Sun and Earth at a place, as scripts and conditions see them.
#pragma once

#include "mission/port/rover_port.h"
#include "planet/sunlight.h"

namespace lsos {

SkyView sky_view(const Body& body, const Geodetic& place, Instant utc);

}  // namespace lsos
