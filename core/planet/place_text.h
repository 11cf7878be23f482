// Places that a planner writes as two numbers.
#pragma once

#include <string>

#include "base/parsed.h"
#include "planet/body.h"

namespace lsos {

// "46.3,-89.84": longitude, then latitude, in degrees; both may say their unit. Allowed are
// longitudes of -180..360 and latitudes of -90..90 deg. The height is 0.
Parsed<Geodetic> parse_lon_lat(const std::string& text);

// The reverse, to 12 digits: read again it is the same place to a nanometre.
std::string lon_lat_text(const Geodetic& place);

}  // namespace lsos
