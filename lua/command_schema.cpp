// `lsos-host schema`: what a plan can hold, as KML: <Schema> elements for a map's forms, and a plan
// with one Placemark of each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "lua/commands.h"
#include "lua/console.h"
#include "lua/mission_files.h"
#include "plan/field_reader.h"
#include "plan/kml_writer.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr const char* rover_id = "A";
constexpr const char* asset_id = "Base";

std::string kml_type(FieldKind kind) {
  switch (kind) {
    case FieldKind::integer:
      return "int";
    case FieldKind::boolean:
      return "bool";
    default:
      return "string";  // numbers may carry units
  }
}

// 1 where that is allowed, else the nearest that is.
std::string allowed_number(const FieldDeclaration& field) {
  const double least = field.min_si.value_or(-infinite), most = field.max_si.value_or(infinite);
  if (field.kind == FieldKind::integer) {
    return fmt::format("{}", static_cast<std::int64_t>(std::clamp(1.0, least, most)));
  }
  const double factor = field.unit != nullptr ? field.unit->si_factor : 1;
  double value = std::clamp(1.0, least / factor, most / factor);
  // Converted back as a plan's it must not be outside by a rounding.
  while (value * factor < least) value = std::nextafter(value, infinite);
  while (value * factor > most) value = std::nextafter(value, -infinite);
  return fmt::format("{}", value);
}

// What stands in a form where the user has to fill in something.
std::string example(const FieldDeclaration& field) {
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

struct Kind {
  std::string name;
  std::vector<FieldDeclaration> fields;
  KmlGeometry geometry;
};

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

void add(KmlDocument& document, const Kind& kind, int number) {
  KmlSchema schema{kind.name, kind.name, {}};
  KmlPlacemark placemark;
  placemark.name = kind.name;
  placemark.schema_id = kind.name;
  placemark.geometry = kind.geometry;
  // Map tools rewrite schemaUrl: then this still says what the Placemark is.
  schema.fields.push_back({"Type", "string", "what the Placemark is"});
  placemark.data.emplace_back("Type", kind.name);
  for (const FieldDeclaration& field : kind.fields) {
    schema.fields.push_back({field.name, kml_type(field.kind), field.doc});
    placemark.data.emplace_back(field.name,
                                field.name == "Sequence" ? std::to_string(number) : example(field));
  }
  document.schemas.push_back(std::move(schema));
  document.placemarks.push_back(std::move(placemark));
}

// The Placemarks have their values in the order of their schema's fields.
Json kinds_json(const KmlDocument& document) {
  Json kinds = Json::array();
  for (std::size_t k = 0; k < document.schemas.size(); ++k) {
    const KmlSchema& schema = document.schemas[k];
    Json fields = Json::array();
    for (std::size_t i = 0; i < schema.fields.size(); ++i) {
      const KmlField& field = schema.fields[i];
      fields.push_back({{"name", field.name},
                        {"type", field.type},
                        {"doc", field.display_name},
                        {"example", document.placemarks[k].data[i].second}});
    }
    kinds.push_back({{"name", schema.id}, {"fields", fields}});
  }
  return kinds;
}

}  // namespace

int schema_command(const std::vector<std::string>& names, bool is_json) {
  const std::shared_ptr<const Catalog> catalog = read_catalog("");
  const auto& events = catalog->declarations().events;
  std::vector<std::string> known;
  for (const auto& [name, event] : events) known.push_back(name);
  Faults faults;
  for (const std::string& name : names) {
    if (events.contains(name)) continue;
    if (const auto broken = catalog->faults_of(ScriptKind::event, name); !broken.empty()) {
      faults.add(broken);
      continue;
    }
    faults.error({}, fmt::format("there is no event '{}'{}", name, did_you_mean(name, known)));
  }
  faults.throw_if_errors();

  KmlDocument document;
  document.name = "lsos-host plan";
  document.description = "One Placemark of each kind: copy, move and fill in what you need.";
  add(document, {"MissionInfo", mission_fields(), {}}, 0);
  add(document, {"Rover", rover_fields(), {KmlGeometryKind::point, {geodetic_from_degrees(0, 0)}}},
      0);
  add(document,
      {"Asset", asset_fields(), {KmlGeometryKind::point, {geodetic_from_degrees(-0.001, 0)}}}, 0);
  int number = 0;
  for (const auto& [name, event] : events) {
    if (!names.empty() && std::ranges::find(names, name) == names.end()) continue;
    Kind kind{name, event_identity_fields(), example_geometry(event)};
    kind.fields.insert(kind.fields.end(), event.fields.begin(), event.fields.end());
    const auto& common = common_event_fields();
    kind.fields.insert(kind.fields.end(), common.begin(), common.end());
    add(document, kind, number += 10);
  }
  if (is_json) {
    print_result("{}\n", kinds_json(document).dump(2));
  } else {
    print_result("{}", write_kml(document));
  }
  return 0;
}

}  // namespace lsos
