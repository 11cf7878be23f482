// Reading a plan's file, whatever it is.
#pragma once

#include <string>

#include "plan/kml_source.h"

namespace lsos {

// A plan's source, whatever it is: KML, KMZ, or a GeoPackage, which is read anew from `file`.
KmlSource parse_plan(std::string bytes, const std::string& file);
// Reads KML or KMZ. Throws InputError (file, line) when that is not what it is.
KmlSource read_kml(const std::string& file);
KmlSource parse_kml(std::string bytes, const std::string& file);

}  // namespace lsos
