// Fields of a plan's things as texts.
#pragma once

#include <algorithm>
#include <string>

#include "plan/declaration.h"
#include "plan/kml_source.h"

namespace lsos {

// The text of a thing's field; nullptr where it has none. `thing` has one SchemaData.
inline const std::string* thing_field(const SourcePlacemark& thing, const std::string& name) {
  const auto& fields = thing.data.front().fields;
  const auto found = std::ranges::find(fields, name, &SourceField::name);
  return found == fields.end() ? nullptr : &found->text;
}

// MissionInfo, Rover, Asset or an event.
inline const std::string& thing_type(const SourcePlacemark& thing) {
  return thing.data.front().schema;
}

// The declaration of a field that things of that type have; nullptr where they have none.
inline const FieldDeclaration* declared_field(const std::string& type, const std::string& name,
                                              const Declarations& declarations) {
  for (const auto& list : fields_of(type, declarations)) {
    for (const FieldDeclaration& each : list) {
      if (each.name == name) return &each;
    }
  }
  return nullptr;
}

}  // namespace lsos
