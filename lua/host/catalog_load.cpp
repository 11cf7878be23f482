// Loads the scripts of a catalog, and looks up what they define.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "base/resolved_path.h"
#include "lua/api/api.h"
#include "lua/api/constructors.h"
#include "lua/api/rover_constructors.h"
#include "lua/api/terrain_constructors.h"
#include "lua/host/catalog.h"
#include "lua/host/event_library.h"
#include "lua/host/load_budget.h"
#include "lua/host/part_faults.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/text_literal.h"
#include "vehicle/suspension/size_faults.h"

namespace lsos {

namespace {

const char* noun(ScriptKind kind) {
  switch (kind) {
    case ScriptKind::event:
      return "event";
    case ScriptKind::rover:
      return "rover type";
    case ScriptKind::terrain:
      return "terrain";
    case ScriptKind::soil:
      return "soil";
    case ScriptKind::shared:
      return "shared script";
  }
  return "";
}

// File name given to the script that holds a plan's changes. It is never shown, and no file has
// such a name.
constexpr const char* variant_file = "=Variant";

template <class T>
std::vector<std::string> names_of(const std::map<std::string, T>& things) {
  std::vector<std::string> names;
  for (const auto& [name, thing] : things) names.push_back(name);
  return names;
}

template <class T>
std::optional<T> load_as(LuaState& lua, const Script& script, const char* kind, Faults& faults) {
  std::optional<T> value;
  lua.run([&](lua_State* L) {
    if (const ConstructedValue* made = load_script(L, script, kind, faults))
      value = std::any_cast<T>(made->value);
  });
  return value;
}

// Replaces named soils by their values, and makes the paths of rasters relative to the script's
// folder.
void complete(TerrainScript& terrain, const Script& script,
              const std::map<std::string, Soil>& soils, Faults& faults) {
  TerrainSpec& spec = terrain.spec;
  spec.name = script.name;
  const auto locate = [&](RasterSurface& raster) {
    raster.file = resolved_path(script.folder, raster.file);
  };
  const auto chosen = [&](const SoilChoice& choice) {
    if (choice.name.empty()) return choice.soil;
    const auto soil = soils.find(choice.name);
    if (soil != soils.end()) return soil->second;
    faults.error(spec.place, fmt::format("terrain: no soil '{}'{}", choice.name,
                                         did_you_mean(choice.name, names_of(soils))));
    return Soil{};
  };
  for (Surface& layer : spec.layers) {
    if (auto* raster = std::get_if<RasterSurface>(&layer)) locate(*raster);
  }
  spec.soil = chosen(terrain.soil);
  if (terrain.rock_soil) spec.rock_soil = chosen(*terrain.rock_soil);
  for (SoilPatchScript& patch : terrain.soil_patches) {
    patch.patch.soil = chosen(patch.soil);
    if (patch.patch.raster) locate(*patch.patch.raster);
    spec.soil_patches.push_back(std::move(patch.patch));
  }
}

// Faults of shapes that move with a link which the rover does not have.
std::vector<std::string> shape_faults(const RoverModel& model) {
  std::vector<std::string> links;
  for (const LinkConfig& link : make_vehicle(model.spec, "", 1).links) links.push_back(link.name);
  std::vector<std::string> faults;
  for (const Shape& shape : model.shapes) {
    if (shape.part.empty() || std::ranges::find(links, shape.part) != links.end()) continue;
    faults.push_back(fmt::format("shapes: part = '{}': there is no such link{}; links are {}",
                                 shape.part, did_you_mean(shape.part, links),
                                 fmt::join(links, ", ")));
  }
  return faults;
}

// Adds the faults of a rover's vehicle, at most three: wheels are alike, so a fault of one is found
// a dozen times.
void check_vehicle(const RoverModel& model, Faults& faults) {
  const RoverSpec& rover = model.spec;
  std::vector<std::string> found = part_faults(model.shapes, model.power, model.antennas);
  if (found.empty()) found = size_faults(rover);
  if (found.empty()) found = vehicle_faults(rover);
  if (found.empty()) found = shape_faults(model);
  constexpr std::size_t shown_max = 3;
  for (std::size_t i = 0; i < std::min(found.size(), shown_max); ++i) {
    faults.error(rover.place, "rover: " + found[i]);
  }
  if (found.size() > shown_max) {
    faults.error(rover.place, fmt::format("rover: {} more of the kind", found.size() - shown_max));
  }
}

std::optional<HeightRange> heights_of(const RoverSpec& rover) {
  if (!std::holds_alternative<Legged>(rover.suspension)) return {};
  return height_range(make_vehicle(rover, "", 1));
}

std::vector<std::string> configurations_of(const RoverSpec& rover) {
  std::vector<std::string> names;
  for (const RoverConfiguration& configuration : rover.configurations) {
    names.push_back(configuration.name);
  }
  return names;
}

// The keys of lsos.soil that make this soil.
std::string lua_table(const Soil& soil) {
  std::string keys = fmt::format(
      "is_rigid = {}, cohesion_pa = {}, friction_rad = {}, density_kgpm3 = {}, shear_modulus_x_m = "
      "{}, shear_modulus_y_m = {}, slip_sinkage = {}",
      soil.is_rigid, soil.cohesion_pa, soil.friction_rad, soil.density_kgpm3,
      soil.shear_modulus_x_m, soil.shear_modulus_y_m, soil.slip_sinkage);
  if (soil.has_bekker()) {
    keys += fmt::format(", k_c = {}, k_phi = {}, n = {}", soil.k_c, soil.k_phi, soil.n);
  }
  return "{ " + keys + " }";
}

}  // namespace

void Catalog::add_broken(const Script& script, const Faults& faults) {
  for (const Fault& fault : faults.sorted()) {
    broken_[{script.kind, script.name}].push_back(fault);
    faults_.warning(fault.place, fmt::format("the {} '{}' cannot be used: {}", noun(script.kind),
                                             script.name, fault.what));
  }
}

// A script in rovers/ makes a rover or an asset.
void Catalog::load_rover_script(LuaState& lua, const Script& script, Faults& faults) {
  lua.context().bases.clear();
  lua.context().deriving.clear();  // what a script that failed may have left
  lua.run([&](lua_State* L) {
    if (!run_script(L, script, faults)) return;
    if (!lua.context().bases.empty()) bases_[script.name] = lua.context().bases;
    const ConstructedValue* made = to_constructed(L, -1);
    if (made != nullptr && made->kind == asset_kind) {
      auto asset = std::any_cast<AssetModel>(made->value);
      PowerSpec power;
      power.panels = asset.panels;
      for (const std::string& fault : part_faults(asset.shapes, power, {})) {
        faults.error(asset.place, "asset: " + fault);
      }
      if (faults.has_errors()) return;
      declarations_.rover_types[script.name] = {asset.doc, true, {}};
      assets_[script.name] = std::move(asset);
    } else if (made != nullptr && made->kind == rover_kind) {
      auto rover = std::any_cast<RoverModel>(made->value);
      check_vehicle(rover, faults);
      if (faults.has_errors()) return;
      rover.heights = heights_of(rover.spec);
      declarations_.rover_types[script.name] = {rover.spec.doc, false,
                                                configurations_of(rover.spec)};
      rovers_[script.name] = std::move(rover);
    } else {
      faults.error({script.file, 0},
                   fmt::format("must return lsos.rover {{...}} or lsos.asset {{...}}, found {}",
                               describe(L, -1)));
    }
  });
}

void Catalog::load_one(EventLibrary& library, const Script& script, Faults& faults,
                       Faults& event_faults) {
  switch (script.kind) {
    case ScriptKind::event:
      library.load(script, event_faults);
      break;
    case ScriptKind::rover:
      load_rover_script(library.lua(), script, faults);
      break;
    case ScriptKind::soil:
      if (auto soil = load_as<Soil>(library.lua(), script, soil_kind, faults)) {
        soils_[script.name] = std::move(*soil);
      }
      break;
    case ScriptKind::terrain:
      if (auto terrain = load_as<TerrainScript>(library.lua(), script, terrain_kind, faults)) {
        complete(*terrain, script, soils_, faults);
        if (!faults.has_errors()) terrains_[script.name] = std::move(terrain->spec);
      }
      break;
    case ScriptKind::shared:
      break;  // runs for the scripts that require it
  }
}

// Terrains name soils, so soils come before terrains in scripts_.
void Catalog::load_all() {
  EventLibrary library;
  LuaContext& context = library.lua().context();
  context.scripts = &scripts_;
  LoadBudget budget(library.lua());
  std::map<std::string, Faults> event_faults;
  for (const Script& script : scripts_) {
    if (script.kind == ScriptKind::shared) continue;
    const bool is_event = script.kind == ScriptKind::event;
    Faults faults;
    Faults& of_event = is_event ? event_faults[script.name] : faults;
    context.required.clear();
    budget.spend(script, of_event, [&] { load_one(library, script, faults, of_event); });
    required_[{script.kind, script.name}] = context.required;
    if (is_event && of_event.has_errors()) library.remove(script.name);
    add_broken(script, faults);
  }
  library.check_sub_events(event_faults);
  for (const Script& script : scripts_) {
    if (script.kind == ScriptKind::event) add_broken(script, event_faults[script.name]);
  }
  for (const auto& [name, event] : library.events()) declarations_.events[name] = event.declaration;
  declarations_.terrains = names_of(terrains_);
  for (const auto& [key, faults] : broken_) {
    if (key.first == ScriptKind::event) declarations_.broken_events[key.second] = faults;
    if (key.first == ScriptKind::rover) declarations_.broken_rovers[key.second] = faults;
    if (key.first == ScriptKind::terrain) declarations_.broken_terrains[key.second] = faults;
  }
}

std::vector<Fault> Catalog::faults_of(ScriptKind kind, const std::string& name) const {
  const auto found = broken_.find({kind, name});
  return found == broken_.end() ? std::vector<Fault>{} : found->second;
}

template <class T>
const T& Catalog::find(const std::map<std::string, T>& things, ScriptKind kind,
                       const std::string& name, const Place& requested_at) const {
  const auto found = things.find(name);
  if (found != things.end()) return found->second;
  if (std::vector<Fault> faults = faults_of(kind, name); !faults.empty()) {
    throw InputError(std::move(faults));
  }
  throw InputError(requested_at, fmt::format("no {} '{}'{}", noun(kind), name,
                                             did_you_mean(name, names_of(things))));
}

RoverModel Catalog::load_rover(const std::string& name, const Place& requested_at) const {
  return find(rovers_, ScriptKind::rover, name, requested_at);
}

RoverModel Catalog::load_variant(const std::string& name, const std::string& changes,
                                 const std::string& what, const Place& requested_at,
                                 Faults& faults) const {
  LuaState lua(make_api);
  lua.context().scripts = &scripts_;
  Script script;
  script.kind = ScriptKind::rover;
  script.name = name;
  script.file = variant_file;
  script.source = fmt::format("local lsos = require 'lsos'; return lsos.derive({}, {})",
                              lua_text(name), changes);
  Faults found;
  std::optional<RoverModel> model = load_as<RoverModel>(lua, script, rover_kind, found);
  if (model && !found.has_errors()) check_vehicle(*model, found);
  if (model && !found.has_errors()) model->heights = heights_of(model->spec);
  for (const std::string& doubt : lua.context().doubts) found.warning({}, doubt);
  std::vector<Fault> reported;
  for (const Fault& fault : found.sorted()) {
    reported.push_back({fault.severity, requested_at, fmt::format("{}: {}", what, fault.what)});
  }
  if (found.has_errors()) throw InputError(std::move(reported));
  faults.add(reported);
  model->spec.name = model->spec.vehicle.type = name;
  model->spec.place = requested_at;
  const std::string as_script = script_name(variant_file) + ": is ";
  for (std::string& assumption : model->spec.vehicle.assumptions) {
    if (!assumption.starts_with(as_script)) continue;
    assumption = fmt::format("{}: {}", what, assumption.substr(as_script.size()));
  }
  return *model;
}

std::set<std::string> Catalog::bases_of(const std::string& name) const {
  const auto found = bases_.find(name);
  return found == bases_.end() ? std::set<std::string>{} : found->second;
}

std::set<std::string> Catalog::required_by(ScriptKind kind, const std::string& name) const {
  const auto found = required_.find({kind, name});
  return found == required_.end() ? std::set<std::string>{} : found->second;
}

Soil Catalog::changed_soil(const Soil& soil, const std::string& changes, const std::string& what,
                           const Place& requested_at) const {
  Script script;
  script.kind = ScriptKind::soil;
  script.name = soil.name;
  script.file = variant_file;
  script.source = fmt::format(
      "local lsos = require 'lsos'\nlocal soil = {}\nfor key, value in pairs({}) do soil[key] = "
      "value end\nreturn lsos.soil(soil)",
      lua_table(soil), changes);
  LuaState lua(make_api);
  Faults found;
  std::optional<Soil> changed = load_as<Soil>(lua, script, soil_kind, found);
  std::vector<Fault> reported;
  for (const Fault& fault : found.sorted()) {
    reported.push_back({fault.severity, requested_at, fmt::format("{}: {}", what, fault.what)});
  }
  if (!changed) throw InputError(std::move(reported));
  changed->name = soil.name;
  changed->doc = soil.doc;
  return *changed;
}

AssetModel Catalog::load_asset(const std::string& name, const Place& requested_at) const {
  return find(assets_, ScriptKind::rover, name, requested_at);
}

TerrainSpec Catalog::load_terrain(const std::string& name, const Place& requested_at) const {
  return find(terrains_, ScriptKind::terrain, name, requested_at);
}

Soil Catalog::load_soil(const std::string& name, const Place& requested_at) const {
  return find(soils_, ScriptKind::soil, name, requested_at);
}

}  // namespace lsos
