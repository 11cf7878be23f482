// Kinds of Placemarks that a plan can have, with their fields, as KML schemas and as examples.
#pragma once

#include <string>
#include <vector>

#include "lua/host/catalog.h"
#include "plan/kml_writer.h"

namespace lsos {

struct Kind {
  std::string name, doc;
  std::vector<FieldDeclaration> fields;
  KmlGeometry geometry;  // an example
  bool is_event = false;
};

// MissionInfo, Rover, Asset, and the events of those names; all events if `names` is empty.
std::vector<Kind> kinds_of(const Catalog& catalog, const std::vector<std::string>& names);

// Text that a form shows where the user has to fill in a value.
std::string example_value(const FieldDeclaration& field);

// Adds the schema of a kind, and a Placemark with an example of each field. `number`: its Sequence.
void add_example(KmlDocument& document, const Kind& kind, int number);
// The schema of a kind, with a field Type.
KmlSchema schema_of(const Kind& kind);

}  // namespace lsos
