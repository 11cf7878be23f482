// Writes an empty plan as a GeoPackage: one layer for each kind of Placemark, with styles for QGIS.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "planet/body.h"

namespace lsos {

struct FormField {
  FieldDeclaration declaration;
  std::string initial;               // value in a new feature; "": none
  std::vector<std::string> choices;  // allowed values; empty: any text
};

// One layer, whose features are Placemarks of that name.
struct FormLayer {
  std::string name, doc;
  GeometryKind geometry = GeometryKind::none;
  std::vector<FormField> fields;
  bool has_first_row = false;  // a first feature with the initial values is written
  std::string style = {};      // QGIS style of the layer
};

// Throws InputError when the file exists or cannot be written.
void write_form_layers(const std::string& file, const Body& body,
                       const std::vector<FormLayer>& layers);

}  // namespace lsos
