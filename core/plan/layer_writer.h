// An empty plan as a GeoPackage: a layer for each kind of thing, with styles for QGIS.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "planet/body.h"

namespace lsos {

struct FormField {
  FieldDeclaration declaration;
  std::string initial;               // what a new feature has; "": nothing
  std::vector<std::string> choices;  // what it may be; empty: any text
};

// One layer: the features of a NAME.
struct FormLayer {
  std::string name, doc;
  GeometryKind geometry = GeometryKind::none;
  std::vector<FormField> fields;
  bool has_first_row = false;  // with the initial values
  std::string style = {};      // under which QGIS opens it
};

// Throws InputError when it cannot be written, or is there.
void write_form_layers(const std::string& file, const Body& body,
                       const std::vector<FormLayer>& layers);

}  // namespace lsos
