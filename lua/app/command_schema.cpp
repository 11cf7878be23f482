// `lsos-host schema`: writes what a plan can hold, as KML <Schema> elements for a map's forms and a
// plan with one Placemark of each; or as the empty layers of a GeoPackage with forms for QGIS.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/app/commands.h"
#include "lua/host/mission_reader.h"
#include "lua/session/schema_kinds.h"
#include "plan/field_reader.h"
#include "plan/layer_writer.h"
#include "product/qgis_form.h"

namespace lsos {

namespace {

// KML <Schema> elements, and a plan with one Placemark each, of these events or of all.
// As KML; or the names, types, docs and examples of the fields as JSON.
struct SchemaOptions {
  std::vector<std::string> names;  // events; none: all
  bool is_json = false;
  std::string file;             // .kml or .gpkg; "": KML on standard output
  std::string planet = "Moon";  // of a GeoPackage
};

using Json = nlohmann::ordered_json;

// Kinds of Placemarks that any plan has besides its events.
constexpr std::array<std::string_view, 3> always{"MissionInfo", "Rover", "Asset"};

// Choices that a form offers for a field.
std::vector<std::string> choices_of(const FieldDeclaration& field, const Catalog& catalog) {
  const bool is_asset = field.name == "AssetType";
  if (field.name != "RoverType" && !is_asset) return field.choices;
  std::vector<std::string> types;
  for (const auto& [name, type] : catalog.declarations().rover_types) {
    if (type.is_asset == is_asset) types.push_back(name);
  }
  return types;
}

// Value of a field in a new feature: its default, or an example where it is required; else "".
std::string initial_value(const FieldDeclaration& field, std::string_view planet) {
  if (field.name == "Planet") return std::string(planet);
  if (field.kind == FieldKind::boolean && field.default_value) {
    return std::get<bool>(*field.default_value) ? "1" : "0";
  }
  if (field.default_value) return format_value(field, *field.default_value);
  const bool is_an_id =
      field.name == "RoverId" || field.name == "AssetId" || field.name == "Sequence";
  const std::string shown = is_an_id ? "" : example_value(field);
  return field.is_required && shown != "?" ? shown : "";
}

// Geometry of a kind's layer: the first of polygon, line and point that its event can have. A line
// is thus drawn where a point would do as well, and an event that needs no place may have a point.
GeometryKind form_geometry(const Kind& kind, const Catalog& catalog) {
  if (kind.name == "MissionInfo") return GeometryKind::none;
  if (!kind.is_event) return GeometryKind::point;
  const auto& kinds = catalog.declarations().events.at(kind.name).geometries;
  for (const GeometryKind each : {GeometryKind::polygon, GeometryKind::line, GeometryKind::point}) {
    if (std::ranges::find(kinds, each) != kinds.end()) return each;
  }
  return GeometryKind::none;
}

std::vector<FormLayer> form_layers(const std::vector<Kind>& kinds, const Catalog& catalog,
                                   std::string_view planet) {
  std::vector<FormLayer> layers;
  for (const Kind& kind : kinds) {
    FormLayer layer{
        kind.name, kind.doc, form_geometry(kind, catalog), {}, kind.name == "MissionInfo"};
    for (const FieldDeclaration& field : kind.fields) {
      layer.fields.push_back({field, initial_value(field, planet), choices_of(field, catalog)});
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

// Relies on Placemarks that have their values in the order of their schema's fields.
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

int schema_command(const SchemaOptions& options) {
  const std::vector<std::string>& names = options.names;
  const std::shared_ptr<const Catalog> catalog = read_catalog("");
  const auto& events = catalog->declarations().events;
  std::vector<std::string> known;
  for (const auto& [name, event] : events) known.push_back(name);
  Faults faults;
  for (const std::string_view name : always) known.emplace_back(name);
  for (const std::string& name : names) {
    if (events.contains(name) || std::ranges::find(always, name) != always.end()) continue;
    if (const auto broken = catalog->faults_of(ScriptKind::event, name); !broken.empty()) {
      faults.add(broken);
      continue;
    }
    faults.error({}, fmt::format("there is no event '{}'{}", name, did_you_mean(name, known)));
  }
  if (!options.file.empty()) check_output("-o", options.file, {".kml", ".gpkg"}, {}, faults);
  check_free("-o", options.file, "it is not replaced", faults);
  const Body* planet = find_body(options.planet);
  if (planet == nullptr) {
    faults.error({}, fmt::format("--planet {}: there are Moon, Mars, Earth", options.planet));
  }
  faults.throw_if_errors();

  const std::vector<Kind> kinds = kinds_of(*catalog, names);
  if (options.file.ends_with(".gpkg")) {
    std::vector<FormLayer> layers = form_layers(kinds, *catalog, planet->name);
    add_qgis_forms(layers);
    write_form_layers(options.file, *planet, layers);
    print_result("{}: {} layers; open it in QGIS, draw, fill in the forms, and run it as a plan\n",
                 options.file, kinds.size());
    return 0;
  }
  KmlDocument document;
  document.name = "lsos-host plan";
  document.target = target_of(*planet);
  document.description = "One Placemark of each kind: copy, move and fill in what you need.";
  int number = 0;
  for (const Kind& kind : kinds) add_example(document, kind, kind.is_event ? number += 10 : 0);
  if (!options.file.empty()) {
    write_new_file(options.file, write_kml(document));
  } else if (options.is_json) {
    print_result(
        "{}\n", kinds_json(document).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_result("{}", write_kml(document));
  }
  return 0;
}

}  // namespace

std::function<int()> prepare_schema(CommandOptions& command) {
  const auto options = std::make_shared<SchemaOptions>();
  command.add_option("NAME", options->names, "Events (all)");
  command.add_option("-o,--output", options->file,
                     "X.kml, or X.gpkg: empty layers with forms, to draw a plan in QGIS");
  command.add_option("--planet", options->planet, "Of the layers: Moon, Mars or Earth (Moon)");
  command.add_flag("--json", options->is_json, "The fields of each as JSON, in place of KML");
  return [options] { return schema_command(*options); };
}

}  // namespace lsos
