// Places that a planner writes as two numbers.
#pragma once

#include <string>

#include "base/parsed.h"
#include "planet/body.h"

namespace lsos {

// "46.3,-89.84": longitude, then latitude, in degrees; both may say their unit. Allowed are
// longitudes of -180..360 and latitudes of -90..90 deg. The height is 0.
Parsed<Geodetic> parse_lon_lat(const std::string& text);

// The reverse, in as few digits as are read as the same place to the last bit. The place must come
// from degrees, as all of a plan do: others may be off by the last bit.
std::string lon_lat_text(const Geodetic& place);

}  // namespace lsos
