#include "lua/session/schema_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rounding.h"
#include "plan/field_reader.h"

namespace lsos {

namespace {

constexpr const char* rover_id = "A";
constexpr const char* asset_id = "Base";

std::string kml_type(FieldKind kind) {
  switch (kind) {
    case FieldKind::integer:
      return "int";
    default:
      return "string";  // numbers may carry units, and GDAL reads "true" of a bool as 0
  }
}

// 1 where the field allows it, else the nearest allowed number.
std::string allowed_number(const FieldDeclaration& field) {
  const double least = field.min_si.value_or(-infinite), most = field.max_si.value_or(infinite);
  if (field.kind == FieldKind::integer) {
    return fmt::format("{}", static_cast<std::int64_t>(std::clamp(1.0, least, most)));
  }
  const double factor = field.unit != nullptr ? field.unit->si_factor : 1;
  double value = std::clamp(1.0, least / factor, most / factor);
  // Read back from a plan, the value must not be out of range by a rounding error.
  while (value * factor < least) value = std::nextafter(value, infinite);
  while (value * factor > most) value = std::nextafter(value, -infinite);
  return fmt::format("{}", value);
}

KmlGeometry example_geometry(const EventDeclaration& event) {
  const auto takes = [&](GeometryKind kind) {
    return std::ranges::find(event.geometries, kind) != event.geometries.end();
  };
  const std::vector<Geodetic> corners{geodetic_from_degrees(0, 0), geodetic_from_degrees(0.001, 0),
                                      geodetic_from_degrees(0.001, 0.001)};
  if (takes(GeometryKind::none)) return {};
  if (takes(GeometryKind::line)) return {KmlGeometryKind::line, {corners[0], corners[1]}};
  if (takes(GeometryKind::point)) return {KmlGeometryKind::point, {corners[1]}};
  return {KmlGeometryKind::polygon, corners};
}

}  // namespace

std::string example_value(const FieldDeclaration& field) {
  if (!field.example.empty()) return field.example;
  if (field.default_value) return format_value(field, *field.default_value);
  if (!field.is_required) return "";
  if (field.name == "RoverId") return rover_id;
  if (field.name == "RoverType") return "SEV";
  if (field.name == "AssetId" || field.names == NameOf::other) return asset_id;
  if (field.name == "AssetType") return "Habitat";
  if (field.name == "Terrain") return "Flat";
  switch (field.kind) {
    case FieldKind::choice:
      return field.choices.front();
    case FieldKind::duration:
    case FieldKind::moment:
      return "60 s";
    case FieldKind::utc:
      return "2026-07-01T00:00:00Z";
    case FieldKind::number:
    case FieldKind::integer:
      return allowed_number(field);
    case FieldKind::boolean:
      return "1";
    case FieldKind::text:
      return "?";
  }
  return "";
}

std::vector<Kind> kinds_of(const Catalog& catalog, const std::vector<std::string>& names) {
  const auto point = [](double lon_deg) {
    return KmlGeometry{KmlGeometryKind::point, {geodetic_from_degrees(lon_deg, 0)}};
  };
  std::vector<Kind> kinds{
      {"MissionInfo", "The mission as a whole: one of these", mission_fields(), {}},
      {"Rover", "Rovers, where they start", rover_fields(), point(0)},
      {"Asset", "Habitats, comm stations and solar arrays", asset_fields(), point(-0.001)}};
  for (const auto& [name, event] : catalog.declarations().events) {
    if (!names.empty() && std::ranges::find(names, name) == names.end()) continue;
    Kind kind{name, event.doc, event_identity_fields(), example_geometry(event), true};
    kind.fields.insert(kind.fields.end(), event.fields.begin(), event.fields.end());
    const auto& common = common_event_fields();
    kind.fields.insert(kind.fields.end(), common.begin(), common.end());
    kinds.push_back(std::move(kind));
  }
  return kinds;
}

KmlSchema schema_of(const Kind& kind) {
  KmlSchema schema{kind.name, kind.name, {}};
  // Map tools may rewrite schemaUrl; this field then still states the kind of the Placemark.
  schema.fields.push_back({"Type", "string", "what the Placemark is"});
  for (const FieldDeclaration& field : kind.fields) {
    schema.fields.push_back({field.name, kml_type(field.kind), field.doc});
  }
  return schema;
}

void add_example(KmlDocument& document, const Kind& kind, int number) {
  KmlPlacemark placemark;
  placemark.name = kind.name;
  placemark.schema_id = kind.name;
  placemark.geometry = kind.geometry;
  placemark.data.emplace_back("Type", kind.name);
  for (const FieldDeclaration& field : kind.fields) {
    placemark.data.emplace_back(
        field.name, field.name == "Sequence" ? std::to_string(number) : example_value(field));
  }
  document.schemas.push_back(schema_of(kind));
  document.placemarks.push_back(std::move(placemark));
}

}  // namespace lsos
