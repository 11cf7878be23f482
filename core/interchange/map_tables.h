// Features of maps as tables.
#pragma once

#include <string>
#include <vector>

#include "interchange/table.h"
#include "plan/kml_source.h"

namespace lsos {

// A table for each kind of Placemark of a KML document, and for each layer of a map: its features
// with their data and geometry, named after the Schema, else the folder or layer.
std::vector<Table> tables_of(const KmlSource& source);

}  // namespace lsos
