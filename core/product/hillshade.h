// Hillshade of the ground about a site for GIS tools, lit from the north-west.
#pragma once

#include <string>

#include "terrain/ground.h"

namespace lsos {

// Extent of a map, metres east and north of the site's origin.
struct MapExtent {
  double west_m = 0, south_m = 0, east_m = 0, north_m = 0;
};

// Writes a GeoTIFF in a stereographic projection about the site's origin. Returns the map's CRS,
// WKT. Throws InputError when it cannot be written.
std::string write_hillshade(const std::string& file, const Ground& ground, const MapExtent& extent,
                            double cell_m);
// WKT of the geographic CRS of the site's body.
std::string geographic_crs(const Ground& ground);

}  // namespace lsos
