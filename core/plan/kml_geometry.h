// Reads the geometry elements of KML, with their coordinates as written.
#pragma once

#include <string_view>

#include "plan/kml_source.h"
#include "plan/xml_element.h"

namespace lsos {

// Whether an element of that name, without its prefix, is a geometry.
bool is_geometry(std::string_view name);

// Whether it is a MultiGeometry without members, which some tools write for a Placemark without a
// place.
bool is_empty_multi(const tinyxml2::XMLElement& element);

// Reads one geometry. A MultiGeometry or MultiTrack with one member is read as that member; a
// LinearRing and a Track, whose coordinates are separated by blanks, become LineStrings.
SourceGeometry read_kml_geometry(const tinyxml2::XMLElement& element);

}  // namespace lsos
