// `lsos-host list`: lists what a plan can name, with fields, units, ranges and defaults.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/console.h"
#include "base/quantity.h"
#include "lua/app/commands.h"
#include "lua/host/mission_reader.h"
#include "plan/geometry.h"

namespace lsos {

namespace {

struct ListOptions {
  std::string what;  // events, rovers, terrains, soils
  std::string name;  // "": all
  bool is_json = false;
};

// Without what converting units adds to the last digits.
double rounded(double value) { return std::stod(fmt::format("{:.12g}", value)); }

using Json = nlohmann::ordered_json;

const char* to_text(FieldKind kind) {
  constexpr const char* names[] = {"number", "integer",  "boolean", "text",
                                   "choice", "duration", "utc",     "moment"};
  return names[static_cast<int>(kind)];
}

const char* to_text(GeometryKind kind) {
  constexpr const char* names[] = {"none", "point", "line", "polygon"};
  return names[static_cast<int>(kind)];
}

std::string default_text(const FieldDeclaration& field) {
  if (!field.default_value) return "";
  if (const auto* number = std::get_if<double>(&*field.default_value)) {
    return field.unit ? format_quantity(*number, *field.unit) : fmt::format("{}", *number);
  }
  if (const auto* integer = std::get_if<std::int64_t>(&*field.default_value)) {
    return std::to_string(*integer);
  }
  if (const auto* truth = std::get_if<bool>(&*field.default_value))
    return *truth ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&*field.default_value)) return *text;
  return format_utc(std::get<Instant>(*field.default_value));
}

// Unit of a bare number in a plan: seconds for every duration, none for whole numbers.
const Unit* bare_unit(const FieldDeclaration& field) {
  return field.kind == FieldKind::duration ? find_unit("s") : field.unit;
}

double si_factor(const FieldDeclaration& field) {
  return bare_unit(field) != nullptr ? bare_unit(field)->si_factor : 1;
}

// Whether the field has a maximum other than the one that all durations have.
bool has_own_maximum(const FieldDeclaration& field) {
  return field.max_si &&
         !(field.kind == FieldKind::duration && *field.max_si == longest_duration_s);
}

Json field_json(const FieldDeclaration& field) {
  Json json{{"name", field.name},
            {"key", field.key},
            {"kind", to_text(field.kind)},
            {"required", field.is_required},
            {"doc", field.doc}};
  if (const Unit* unit = bare_unit(field)) json["unit"] = unit->symbol;
  const double factor = si_factor(field);
  if (field.min_si) json["min"] = rounded(*field.min_si / factor);
  if (has_own_maximum(field)) json["max"] = rounded(*field.max_si / factor);
  if (!field.choices.empty()) json["choices"] = field.choices;
  if (field.default_value) json["default"] = default_text(field);
  return json;
}

std::string field_text(const FieldDeclaration& field) {
  std::string text = fmt::format("  {:<16} {}", field.name, to_text(field.kind));
  const bool has_unit = field.unit != nullptr && field.unit->symbol != "1";
  if (has_unit) text += fmt::format(", {}", bare_unit(field)->symbol);
  const double factor = si_factor(field);
  if (field.min_si) text += fmt::format(", at least {}", rounded(*field.min_si / factor));
  if (has_own_maximum(field)) text += fmt::format(", at most {}", rounded(*field.max_si / factor));
  if (!field.choices.empty()) text += fmt::format(": {}", fmt::join(field.choices, ", "));
  if (field.is_required) text += ", required";
  if (field.default_value) text += fmt::format(", default {}", default_text(field));
  if (!field.doc.empty()) text += fmt::format(" - {}", field.doc);
  return text + "\n";
}

struct Listed {
  std::string name, doc;
  std::vector<GeometryKind> geometries = {};  // events only
  std::vector<FieldDeclaration> fields = {};
  std::optional<RoverModel> rover = {};
  bool is_asset = false;
};

template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

std::vector<Listed> listed(const Catalog& catalog, const std::string& what) {
  std::vector<Listed> all;
  const Declarations& declarations = catalog.declarations();
  if (what == "events") {
    for (const auto& [name, event] : declarations.events) {
      all.push_back({name, event.doc, event.geometries, event.fields});
    }
  } else if (what == "rovers") {
    for (const auto& [name, rover] : declarations.rover_types) {
      all.push_back({name, rover.doc});
      all.back().is_asset = rover.is_asset;
      if (!rover.is_asset) all.back().rover = catalog.load_rover(name);
    }
  } else if (what == "terrains") {
    for (const std::string& name : declarations.terrains) {
      all.push_back({name, catalog.load_terrain(name).doc});
    }
  } else {
    for (const Script& script : catalog.scripts()) {
      if (script.kind != ScriptKind::soil) continue;
      if (!catalog.faults_of(script.kind, script.name).empty()) continue;
      all.push_back({script.name, catalog.load_soil(script.name).doc});
    }
  }
  return all;
}

Json listed_json(const Listed& one) {
  Json json{{"name", one.name}, {"doc", one.doc}, {"fields", Json::array()}};
  for (const FieldDeclaration& field : one.fields) json["fields"].push_back(field_json(field));
  for (const GeometryKind geometry : one.geometries) {
    json["geometries"].push_back(to_text(geometry));
  }
  if (one.rover || one.is_asset) json["is_asset"] = one.is_asset;
  if (!one.rover) return json;
  json["configurations"] = Json::array();
  for (const RoverConfiguration& configuration : one.rover->spec.configurations) {
    json["configurations"].push_back({{"name", configuration.name}, {"doc", configuration.doc}});
  }
  json["panels"] = names(one.rover->power.panels);
  json["antennas"] = Json::array();
  for (const AntennaSpec& antenna : one.rover->antennas) {
    json["antennas"].push_back({{"name", antenna.name}, {"is_stowable", antenna.is_stowable()}});
  }
  json["resources"] = Json::array();
  for (const ResourceSpec& resource : one.rover->power.resources) {
    json["resources"].push_back({{"name", resource.name}, {"unit", resource.unit}});
  }
  return json;
}

std::string listed_text(const Listed& one) {
  std::string text = fmt::format("{}{}{}{}\n", one.name, one.is_asset ? " (asset)" : "",
                                 one.doc.empty() ? "" : ": ", one.doc);
  if (!one.geometries.empty()) {
    text += fmt::format("  drawn as {}\n", geometries_text(one.geometries));
  }
  for (const FieldDeclaration& field : one.fields) text += field_text(field);
  if (!one.rover) return text;
  for (const RoverConfiguration& configuration : one.rover->spec.configurations) {
    text += fmt::format("  RoverConfig {}: {}\n", configuration.name, configuration.doc);
  }
  const PowerSpec& power = one.rover->power;
  if (!power.panels.empty()) {
    text += fmt::format("  panels: {}\n", fmt::join(names(power.panels), ", "));
  }
  std::vector<std::string> antennas, resources;
  for (const AntennaSpec& antenna : one.rover->antennas) {
    antennas.push_back(antenna.name + (antenna.is_stowable() ? " (stowed at the start)" : ""));
  }
  if (!antennas.empty()) text += fmt::format("  antennas: {}\n", fmt::join(antennas, ", "));
  for (const ResourceSpec& resource : power.resources) {
    resources.push_back(fmt::format("{} ({})", resource.name, resource.unit));
  }
  if (!resources.empty()) text += fmt::format("  resources: {}\n", fmt::join(resources, ", "));
  return text;
}

int list_command(const ListOptions& options) {
  const auto catalog = read_catalog("");
  // Broken and hidden scripts are not listed, but they are reported on standard error.
  for (const Fault& fault : catalog->faults().sorted()) {
    print_message("{}\n", to_string(fault));
  }
  std::vector<Listed> all = listed(*catalog, options.what);
  if (!options.name.empty()) {
    std::vector<std::string> names;
    for (const Listed& one : all) names.push_back(one.name);
    std::erase_if(all, [&](const Listed& one) { return one.name != options.name; });
    if (all.empty()) {
      throw InputError({}, fmt::format("'{}' is not among the {}{}", options.name, options.what,
                                       did_you_mean(options.name, names)));
    }
  }
  Json json = Json::array();
  for (const Listed& one : all) {
    if (options.is_json) {
      json.push_back(listed_json(one));
    } else {
      print_result("{}", listed_text(one));
    }
  }
  if (options.is_json)
    print_result("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  if (!options.is_json && options.what == "events") {
    print_result("Every event also has:\n");
    for (const FieldDeclaration& field : common_event_fields())
      print_result("{}", field_text(field));
  }
  return 0;
}

}  // namespace

std::function<int()> prepare_list(CommandOptions& command) {
  const auto options = std::make_shared<ListOptions>();
  command.add_option("WHAT", options->what, "events, rovers, terrains or soils")
      .required()
      .one_of({"events", "rovers", "terrains", "soils"});
  command.add_option("NAME", options->name, "Only this one");
  command.add_flag("--json", options->is_json, "As JSON");
  return [options] { return list_command(*options); };
}

}  // namespace lsos
