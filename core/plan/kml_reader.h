// Reads a KML document into plain values: its Placemarks with data and geometry, each with the file
// and line it came from. The values are not interpreted here.
#pragma once

#include <string>

#include "plan/kml_source.h"

namespace lsos {

// Reads a plan's source of any kind: KML, KMZ, or a GeoPackage, which GDAL reads from `file`
// itself. Throws InputError.
KmlSource parse_plan(std::string bytes, const std::string& file);
// Reads KML or KMZ. Throws InputError (file, line) when it is neither.
KmlSource read_kml(const std::string& file);
KmlSource parse_kml(std::string bytes, const std::string& file);

}  // namespace lsos
