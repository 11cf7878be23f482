#include "lua/host/mission_reader.h"
#include "interchange/plan_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "access/file_access.h"
#include "base/files.h"
#include "base/parsed.h"
#include "lua/host/cached_routes.h"
#include "lua/host/event_check.h"
#include "lua/host/host.h"
#include "lua/host/model_advice.h"
#include "lua/host/plan_table.h"
#include "lua/host/script_folders.h"
#include "lua/host/script_use.h"
#include "lua/host/variant.h"
#include "mission/model/followings.h"
#include "mission/model/mission_span.h"
#include "mission/model/plan_requests.h"
#include "mission/model/site.h"
#include "plan/kml_reader.h"
#include "plan/kml_text.h"
#include "plan/layer_reader.h"
#include "terrain/spec/terrain_beyond.h"

namespace lsos {

namespace {

TerrainSpec read_terrain(const TerrainName& terrain, const Place& place, const Catalog& catalog) {
  if (!terrain.is_raster) return catalog.load_terrain(terrain.name, place);
  return raster_terrain({terrain.name}, place);
}

// Ground of a raster that the plan names itself: no script says what it is made of.
Soil assumed_soil(const MissionInfo& mission, const Catalog& catalog) {
  const Body& body = mission.planet == nullptr ? *find_body("Moon") : *mission.planet;
  return catalog.load_soil(std::string(body.assumed_soil), mission.place);
}

TerrainSpec terrain_of(const MissionInfo& mission, const Catalog& catalog, MissionFiles& files) {
  TerrainSpec terrain = read_terrain(mission.terrain, mission.place, catalog);
  if (!mission.terrain_beyond.name.empty()) {
    const TerrainSpec beyond = read_terrain(mission.terrain_beyond, mission.place, catalog);
    terrain = with_beyond(std::move(terrain), beyond);
    files.assumptions.push_back(fmt::format("{}: beyond its end the ground is that of {}{}",
                                            terrain.name, beyond.name,
                                            beyond.is_synthetic ? ", which is synthetic" : ""));
  }
  if (!mission.soil.empty()) {
    terrain.soil = catalog.load_soil(mission.soil, mission.place);
  } else if (terrain.soil.name.empty()) {
    terrain.soil = assumed_soil(mission, catalog);
    files.is_soil_assumed = true;
  }
  if (mission.soil_variant.empty()) return terrain;
  const std::string what = "MissionInfo: SoilVariant";
  const Parsed<std::string> changes = variant_table(mission.soil_variant);
  if (!changes) throw InputError(mission.place, fmt::format("{}: {}", what, changes.why));
  terrain.soil = catalog.changed_soil(terrain.soil, *changes.value, what, mission.place);
  terrain.soil.name += " with " + mission.soil_variant;
  return terrain;
}

}  // namespace

std::vector<ScriptFolder> script_folders(const std::string& plan_file) {
  const char* path = std::getenv("LSOS_PATH");
  return script_folders(plan_file, path == nullptr ? "" : path, shipped_scripts());
}

void allow_beside(const std::string& plan_file) {
  allow_folder(std::filesystem::path(plan_file).parent_path().string());
}

void allow_other(const std::string& plan_file) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(plan_file, unreadable)) return;
  try {
    read_plan_source(plan_file);
    allow_beside(plan_file);
  } catch (const InputError&) {
    // Its rasters are then refused by name, should the mission need any.
  }
}

void allow_around(const PlanSource& source) {
  allow_beside(source.file);
  const std::string home = home_of(source.kml, source.file);
  if (home != source.file) allow_other(home);
}

std::shared_ptr<const Catalog> read_catalog(const std::string& plan_file) {
  if (plan_file.empty()) allow_folder(".");  // where its scripts are found
  return std::make_shared<const Catalog>(script_folders(plan_file));
}

std::shared_ptr<const Catalog> read_catalog(const PlanSource& source) {
  return read_catalog(source.is_file ? home_of(source.kml, source.file) : "");
}

namespace {

// Sets MaxDuration where the plan gives none, and lists it among the defaults.
void set_max_duration(MissionFiles& files) {
  Plan& plan = files.plan;
  const bool is_known =
      plan.mission.planet != nullptr && !plan.gaps.start_time && !files.faults.has_errors();
  if (plan.mission.has_max_duration || !is_known) return;
  LuaHost host(*files.catalog);
  const auto is_open_ended = [&](const PlanEvent& event) {
    return host.is_open_ended(event.type, {event.params, {}}, plan.mission.start_time);
  };
  try {
    plan.mission.max_duration = default_max_duration(plan, files.catalog->declarations(),
                                                     files.rover_models, is_open_ended);
  } catch (const ScriptError& error) {
    files.faults.error(plan.mission.place, error.what());
  }
  const double hours = seconds(plan.mission.max_duration) / 3600;
  plan.defaults.push_back(
      fmt::format("MissionInfo: MaxDuration = {}",
                  hours > 999 ? fmt::format("{:g} d", hours / 24) : fmt::format("{:g} h", hours)));
}

// The rover that its script defines, with the changes of its Variant.
RoverModel model_of(const PlanRover& rover, const Catalog& catalog, Faults& faults) {
  if (rover.variant.empty()) return catalog.load_rover(rover.type, rover.place);
  const std::string what = fmt::format("Rover '{}': Variant", rover.id);
  const Parsed<std::string> changes = variant_table(rover.variant);
  if (!changes) throw InputError(rover.place, fmt::format("{}: {}", what, changes.why));
  return catalog.load_variant(rover.type, *changes.value, what, rover.place, faults);
}

// Reads and checks the models that the plan names.
void read_models(MissionFiles& files) {
  const Declarations& declarations = files.catalog->declarations();
  // Types that do not exist have been reported when the plan was read.
  const auto has_type = [&](const std::string& name, bool is_asset) {
    const auto found = declarations.rover_types.find(name);
    return found != declarations.rover_types.end() && found->second.is_asset == is_asset;
  };
  const auto collect = [&](auto load) {
    try {
      load();
    } catch (const InputError& error) {
      files.faults.add(error.faults());
    }
  };
  for (const PlanRover& rover : files.plan.rovers) {
    if (!has_type(rover.type, false)) continue;
    collect([&] {
      files.rover_models.insert({rover.model(), model_of(rover, *files.catalog, files.faults)});
    });
  }
  for (const PlanAsset& asset : files.plan.assets) {
    if (!has_type(asset.type, true)) continue;
    collect([&] {
      files.asset_models.insert({asset.type, files.catalog->load_asset(asset.type, asset.place)});
    });
  }
  check_events(files.plan, files, files.faults);
  check_names(files.plan, files, files.faults);
  check_followings(files.plan, declarations, files.rover_models, files.faults);
  check_plan_requests(files.plan, declarations, files.rover_models, files.asset_models,
                      files.faults);
  set_max_duration(files);
  check_plan_spans(files.plan, declarations, files.rover_models, files.faults);
  const MissionInfo& mission = files.plan.mission;
  const auto is_known = [&](const TerrainName& terrain) {
    return terrain.is_raster || std::ranges::count(declarations.terrains, terrain.name) > 0;
  };
  const TerrainName& beyond = mission.terrain_beyond;
  const bool has_terrain = is_known(mission.terrain) && (beyond.name.empty() || is_known(beyond));
  collect([&] {
    if (!has_terrain) return;
    files.terrain = terrain_of(mission, *files.catalog, files);
    // The simulation checks this too, but it is constructed only for plans without errors.
    const bool is_placed = !files.plan.rovers.empty() && files.plan.gaps.unplaced_rovers.empty();
    if (mission.planet == nullptr || !is_placed || !files.faults.has_errors()) return;
    mission_ground(files.terrain, files.plan);
  });
  add_script_warnings(*files.catalog, ScriptUse(*files.catalog, files.plan, files.terrain),
                      files.faults);
}

}  // namespace

MissionFiles read_mission(const std::string& plan_file, std::optional<std::uint64_t> seed) {
  MissionFiles files;
  files.plan.file = files.plan.home = plan_file;
  // The file is read once: a pipe cannot be read again, and a file may change.
  try {
    const PlanSource source = read_plan_source(plan_file);
    allow_around(source);
    files.catalog = read_catalog(source);
    files.plan_bytes = source.bytes;
    files.plan = read_plan(plan_file, source.kml, files.catalog->declarations(), files.faults);
  } catch (const InputError& error) {
    files.faults.add(error.faults());
  }
  if (files.catalog == nullptr) files.catalog = read_catalog(plan_file);
  if (seed) files.plan.mission.seed = *seed;
  read_models(files);
  check_for_events(files.plan, files.faults);
  add_model_advice(files, false);
  return files;
}

PlanSource read_plan_source(const std::string& plan_file) {
  std::string bytes = read_bytes(plan_file);
  KmlSource source = parse_plan(bytes, plan_file);
  // The plan kept with a run is KML, which any viewer opens.
  if (is_geopackage(bytes)) bytes = kml_of(source);
  return {plan_file, std::move(source), "", std::move(bytes), true};
}

MissionFiles read_mission(const PlanSource& source, std::shared_ptr<const Catalog> catalog,
                          std::optional<std::uint64_t> seed) {
  MissionFiles files;
  files.plan_bytes = source.bytes;
  files.catalog = std::move(catalog);
  files.plan = read_plan(source.file, source.kml, files.catalog->declarations(), files.faults);
  if (seed) files.plan.mission.seed = *seed;
  read_models(files);
  const bool is_soil_given = !source.soil.empty();
  if (is_soil_given && !files.faults.has_errors()) {
    files.terrain.soil = files.catalog->load_soil(source.soil, files.plan.mission.place);
  }
  add_model_advice(files, is_soil_given);
  return files;
}

SimulationSetup simulation_setup(const MissionFiles& files) {
  SimulationSetup setup;
  setup.plan = files.plan;
  setup.rover_models = files.rover_models;
  setup.asset_models = files.asset_models;
  setup.terrain = files.terrain;
  if (files.from) {
    setup.starts = files.from->rovers;
    for (PlanRover& rover : setup.plan.rovers) {
      const auto start = setup.starts.find(rover.id);
      if (start == setup.starts.end()) continue;
      rover.start = *start->second.place;
      rover.heading_rad = start->second.heading_rad;
    }
  }
  setup.cached_legs = read_cached_legs(files.plan.home);
  setup.make_host = [catalog = files.catalog] { return std::make_unique<LuaHost>(*catalog); };
  return setup;
}

}  // namespace lsos
