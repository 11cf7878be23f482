// Reads plans drawn as layers of a GIS: a GeoPackage whose layers are named after event types,
// MissionInfo, Rover or Asset, or have a column Type. Columns are fields.
#pragma once

#include <string>
#include <string_view>

#include "plan/kml_source.h"

namespace lsos {

bool is_geopackage(std::string_view bytes);

// Reads the features of all layers as Placemarks in a folder with the layer's name; the line of
// each is its fid. Places in any CRS are converted to degrees on its body. Throws InputError when
// the file cannot be opened or a layer's CRS cannot be used.
KmlSource read_layers(const std::string& file);
// The same of a map of another format, by the name of GDAL's driver: "GeoJSON", "ESRI Shapefile",
// "GPX" (its waypoints, routes and tracks).
KmlSource read_layers(const std::string& file, const std::string& driver);

}  // namespace lsos
