// Where rovers stand before their events, by what is drawn.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// For each Placemark of a plan the key of the place where its rover stands before it: at the
// rover's start, then at the end of what it last drove. "" where it is not known, and for what is
// no event. Each Placemark has one SchemaData.
std::vector<std::string> places_before(const KmlSource& plan, const Declarations& declarations);

// A drive to "Ridge; Gate" leads there from where its rover stands: lets the lines of the
// Placemarks with these indices begin there, where that is known and they do not yet.
void begin_lines_at_rovers(const std::vector<std::size_t>& ways, const Declarations& declarations,
                           KmlSource& plan);

}  // namespace lsos
