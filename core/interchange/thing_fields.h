// Fields of a plan's things as texts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>

#include "base/quantity.h"
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

// What identifies a thing: its type, "event" for all events; its id, of an event its rover's; and
// its Sequence.
using ThingId = std::tuple<std::string, std::string, std::int64_t>;
inline ThingId thing_id(const SourceData& data) {
  const bool is_owner =
      data.schema == "MissionInfo" || data.schema == "Rover" || data.schema == "Asset";
  ThingId id{is_owner ? data.schema : "event", "", 0};
  for (const SourceField& field : data.fields) {
    if (field.name == (data.schema == "Asset" ? "AssetId" : "RoverId"))
      std::get<1>(id) = field.text;
    if (field.name != "Sequence" || is_owner) continue;
    std::get<2>(id) = parse_integer(field.text).value.value_or(-1);
  }
  return id;
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
