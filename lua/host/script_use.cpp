#include "lua/host/script_use.h"

#include <algorithm>

namespace lsos {

namespace {

using Names = std::set<std::string>;

// Adds an event with the events that it is composed of.
void add_event(const Declarations& declarations, const std::string& name, Names& names) {
  if (name.empty() || !names.insert(name).second) return;
  const auto found = declarations.events.find(name);
  if (found == declarations.events.end()) return;
  for (const EventDeclaration::Phase& phase : found->second.phases) {
    add_event(declarations, phase.sub_event, names);
  }
}

}  // namespace

ScriptUse::ScriptUse(const Catalog& catalog, const Plan& plan, const TerrainSpec& terrain) {
  for (const PlanEvent& event : plan.events) {
    add_event(catalog.declarations(), event.type, events_);
  }
  const auto add_rover = [&](const std::string& type) {
    rovers_.insert(type);
    rovers_.merge(catalog.bases_of(type));
  };
  for (const PlanRover& rover : plan.rovers) add_rover(rover.type);
  for (const PlanAsset& asset : plan.assets) add_rover(asset.type);
  for (const TerrainName& name : {plan.mission.terrain, plan.mission.terrain_beyond}) {
    if (!name.is_raster && !name.name.empty()) terrains_.insert(name.name);
  }
  soils_ = {terrain.soil.name};
  if (terrain.rock_soil) soils_.insert(terrain.rock_soil->name);
  for (const SoilPatch& patch : terrain.soil_patches) soils_.insert(patch.soil.name);
  const auto is_broken = [&](ScriptKind kind, const Names& names) {
    return std::ranges::any_of(
        names, [&](const std::string& name) { return !catalog.faults_of(kind, name).empty(); });
  };
  is_any_event_ = is_broken(ScriptKind::event, events_);
  is_any_soil_ = is_broken(ScriptKind::terrain, terrains_);
  is_any_shared_ = is_any_event_ || is_any_soil_ || is_broken(ScriptKind::rover, rovers_) ||
                   is_broken(ScriptKind::soil, soils_);
  for (const Script& script : catalog.scripts()) {
    if (script.kind != ScriptKind::shared && has(script)) {
      shared_.merge(catalog.required_by(script.kind, script.name));
    }
  }
}

bool ScriptUse::has(const Script& script) const {
  switch (script.kind) {
    case ScriptKind::event:
      return is_any_event_ || events_.contains(script.name);
    case ScriptKind::rover:
      return rovers_.contains(script.name);
    case ScriptKind::terrain:
      return terrains_.contains(script.name);
    case ScriptKind::soil:
      return is_any_soil_ || soils_.contains(script.name);
    case ScriptKind::shared:
      return is_any_shared_ || shared_.contains(script.name);
  }
  return true;
}

void add_script_warnings(const Catalog& catalog, const ScriptUse& use, Faults& faults) {
  Names unused;  // files
  for (const Script& script : catalog.scripts()) {
    if (!use.has(script)) unused.insert(script.file);
  }
  const std::vector<Fault> known = faults.sorted();
  for (const Fault& fault : catalog.faults().sorted()) {
    // A script that the plan names and that is broken has been reported as an error.
    const bool is_known = std::ranges::any_of(known, [&](const Fault& k) {
      return k.place == fault.place && fault.what.ends_with(k.what);
    });
    if (!is_known && !unused.contains(fault.place.file)) faults.warning(fault.place, fault.what);
  }
}

}  // namespace lsos
