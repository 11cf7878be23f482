// Plans drawn as layers of a GIS: a GeoPackage whose layers are named as kinds of things, or have a
// column Type; columns are fields.
#pragma once

#include <string>
#include <string_view>

#include "plan/kml_source.h"

namespace lsos {

bool is_geopackage(std::string_view bytes);

// The features of all layers, as Placemarks that lie in a folder of the layer's name; the line of
// each is its fid. Places in any CRS are turned into degrees on its body. Throws InputError when it
// cannot be opened or a layer's CRS cannot be used.
KmlSource read_layers(const std::string& file);

}  // namespace lsos
