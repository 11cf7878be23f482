// The geometry elements of KML, as written.
#pragma once

#include <string_view>

#include "plan/kml_source.h"
#include "plan/xml_element.h"

namespace lsos {

// `name` is that of the element, without its prefix.
bool is_geometry(std::string_view name);

// A MultiGeometry without members: a Placemark without a place, as some tools write it.
bool is_empty_multi(const tinyxml2::XMLElement& element);

// A MultiGeometry or MultiTrack of one member is that member; a LinearRing and a Track, which has
// its coordinates parted by blanks, are LineStrings.
SourceGeometry read_kml_geometry(const tinyxml2::XMLElement& element);

}  // namespace lsos
