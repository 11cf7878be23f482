#include "lua/mission_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "lua/condition.h"
#include "lua/host.h"
#include "lua/model_advice.h"
#include "lua/plan_table.h"
#include "lua/script_folders.h"
#include "lua/script_use.h"
#include "lua/variant.h"
#include "lua/version.h"
#include "mission/mission_span.h"
#include "mission/plan_aims.h"
#include "mission/plan_names.h"
#include "mission/site.h"
#include "plan/kml_reader.h"
#include "plan/kml_text.h"
#include "plan/layer_reader.h"
#include "product/files.h"
#include "route/refine.h"
#include "terrain/terrain_beyond.h"

namespace lsos {

namespace {

constexpr const char* kept_legs_suffix = ".routes";

// Another build may plan otherwise: what it kept is not ours.
std::string program_stamp() {
  const std::filesystem::path program = "/proc/self/exe";
  std::error_code ignored;
  const auto size = std::filesystem::file_size(program, ignored);
  const auto written = std::filesystem::last_write_time(program, ignored).time_since_epoch();
  return fmt::format("lsos-host {} {} {} {}\n", program_version, size, written.count(),
                     refining_stamp());
}

// Ground of a raster that the plan names itself: no script says what it is made of.
const char* default_soil(const Body* body) {
  if (body != nullptr && body->name == "Mars") return "Ding2011_planetary_simulant";
  if (body != nullptr && body->name == "Earth") return "DrySand";
  return "ApolloNominal";
}

TerrainSpec read_terrain(const TerrainName& terrain, const Place& place, const Catalog& catalog) {
  if (!terrain.is_raster) return catalog.load_terrain(terrain.name, place);
  return raster_terrain({terrain.name}, place);
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
  if (!terrain.soil.name.empty()) return terrain;
  terrain.soil = catalog.load_soil(default_soil(mission.planet), mission.place);
  files.is_soil_assumed = true;
  return terrain;
}

// Where all that is drawn lies.
void add_spans(const Plan& plan, ConditionWorld& world) {
  std::vector<Geodetic> places;
  for (const PlanRover& rover : plan.rovers) {
    if (!plan.gaps.unplaced_rovers.contains(rover.id)) places.push_back(rover.start);
  }
  for (const PlanAsset& asset : plan.assets) places.push_back(asset.position);
  for (const PlanEvent& event : plan.events) {
    places.insert(places.end(), event.geometry.points.begin(), event.geometry.points.end());
  }
  if (places.empty()) return;
  const auto [south, north] = std::ranges::minmax(places, {}, &Geodetic::lat_rad);
  const auto [west, east] = std::ranges::minmax(places, {}, &Geodetic::lon_rad);
  constexpr double half_turn_deg = 180;
  world.lat_deg = {degrees(south.lat_rad), degrees(north.lat_rad)};
  const ConditionWorld::Span lon_deg{degrees(west.lon_rad), degrees(east.lon_rad)};
  if (lon_deg.high - lon_deg.low < half_turn_deg) world.lon_deg = lon_deg;
}

// What is the same for all events, and what of the event's rover is. `model`: nullptr: not known.
ConditionWorld condition_world(ConditionWorld world, const std::string& rover_id,
                               const RoverModel* model) {
  world.own_id = rover_id;
  if (model == nullptr) return world;
  world.are_resources_known = true;
  world.speed_max_mps = model->spec.vehicle.speed_max_mps;
  const auto& battery = model->power.battery;
  if (battery) world.battery_capacity_j = battery->capacity_j;
  world.is_without_battery = !battery;
  world.is_without_panels = model->power.panels.empty();
  for (const ResourceSpec& resource : model->power.resources) {
    world.resources.insert(resource.name);
  }
  return world;
}

}  // namespace

void check_events(const Plan& plan, const MissionFiles& files, Faults& faults) {
  LuaHost host(*files.catalog);
  std::set<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.insert(rover.id);
  for (const PlanAsset& asset : plan.assets) ids.insert(asset.id);
  ids.insert(plan.gaps.unread_ids.begin(), plan.gaps.unread_ids.end());
  ids.erase("");
  ConditionWorld of_plan{"", ids, {}, !plan.gaps.has_ids(), false};
  add_spans(plan, of_plan);
  if (plan.mission.has_max_duration) of_plan.max_duration_s = seconds(plan.mission.max_duration);
  for (const PlanEvent& event : plan.events) {
    const PlanRover* rover = rover_of(plan, event.rover_id);
    const auto model =
        rover == nullptr ? files.rover_models.end() : files.rover_models.find(rover->model());
    const ConditionWorld world = condition_world(
        of_plan, event.rover_id, model == files.rover_models.end() ? nullptr : &model->second);
    const auto check = [&](const char* name, const PlanEvent::Condition& condition) {
      if (condition.text.empty()) return;
      const auto told = [&](const std::string& what) {
        return fmt::format("{} '{}': {} = {}: {}", event.type, event.label, name, condition.text,
                           what);
      };
      const Place place{event.place.file, condition.line};
      if (const std::string fault = host.condition_fault(condition.text, world); !fault.empty()) {
        return faults.error(place, told(fault));
      }
      const std::string doubt = condition_doubt(condition.text, world);
      if (!doubt.empty()) faults.warning(place, told(doubt));
    };
    check("StartWhen", event.start_when);
    check("SkipWhen", event.skip_when);
    check("StopWhen", event.stop_when);
    const bool has_time = std::ranges::any_of(event.params, [](const auto& param) {
      return std::holds_alternative<Instant>(param.second);
    });
    // A script says of a part of its fields what only the rest would make true; and nothing of an
    // event that is left out.
    if (!event.is_enabled || !event.has_all_params || (has_time && plan.gaps.start_time)) continue;
    try {
      const LuaHost::CheckAnswer answer =
          host.check(event.type, {event.params, {}}, plan.mission.start_time, rover,
                     model == files.rover_models.end() ? nullptr : &model->second);
      const auto text = [&](const std::string& what) {
        return fmt::format("{} '{}': {}", event.type, event.label, what);
      };
      if (!answer.fault.empty()) faults.error(event.place, text(answer.fault));
      if (!answer.warning.empty()) faults.warning(event.place, text(answer.warning));
    } catch (const ScriptError& error) {
      faults.error(event.place, fmt::format("{} '{}': {}", event.type, event.label, error.what()));
    }
  }
}

std::vector<ScriptFolder> script_folders(const std::string& plan_file) {
  const char* path = std::getenv("LSOS_PATH");
  return script_folders(plan_file, path == nullptr ? "" : path, shipped_scripts());
}

std::shared_ptr<const Catalog> read_catalog(const std::string& plan_file) {
  return std::make_shared<const Catalog>(script_folders(plan_file));
}

namespace {

// A plan that gives none has one that is said among its defaults.
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

// What its script says, with the changes of its Variant.
RoverModel model_of(const PlanRover& rover, const Catalog& catalog, Faults& faults) {
  if (rover.variant.empty()) return catalog.load_rover(rover.type, rover.place);
  const std::string what = fmt::format("Rover '{}': Variant", rover.id);
  const Parsed<std::string> changes = variant_table(rover.variant);
  if (!changes) throw InputError(rover.place, fmt::format("{}: {}", what, changes.why));
  return catalog.load_variant(rover.type, *changes.value, what, rover.place, faults);
}

// Reads what the plan names.
void read_models(MissionFiles& files) {
  const Declarations& declarations = files.catalog->declarations();
  // Of what there is not, the plan's reader has told.
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
  check_plan_names(files.plan, declarations, files.rover_models, files.asset_models, files.faults);
  check_plan_aims(files.plan, declarations, files.rover_models, files.asset_models, files.faults);
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
    // The simulation does so too, but it is made of plans without errors.
    const bool is_placed = !files.plan.rovers.empty() && files.plan.gaps.unplaced_rovers.empty();
    if (mission.planet == nullptr || !is_placed || !files.faults.has_errors()) return;
    drivable_ground_at(files.terrain, *mission.planet, files.plan.rovers.front().start,
                       mission.seed);
  });
  add_script_warnings(*files.catalog, ScriptUse(*files.catalog, files.plan, files.terrain),
                      files.faults);
}

}  // namespace

MissionFiles read_mission(const std::string& plan_file, std::optional<std::uint64_t> seed) {
  MissionFiles files;
  files.catalog = read_catalog(plan_file);
  files.plan.file = plan_file;
  // Once: a pipe has its bytes no second time, and a file may change.
  try {
    const PlanSource source = read_plan_source(plan_file);
    files.plan_bytes = source.bytes;
    files.plan = read_plan(plan_file, source.kml, files.catalog->declarations(), files.faults);
  } catch (const InputError& error) {
    files.faults.add(error.faults());
  }
  if (seed) files.plan.mission.seed = *seed;
  read_models(files);
  check_for_events(files.plan, files.faults);
  add_model_advice(files, false);
  return files;
}

PlanSource read_plan_source(const std::string& plan_file) {
  std::string bytes = read_bytes(plan_file);
  KmlSource source = parse_plan(bytes, plan_file);
  // What a run keeps is a map that any viewer opens.
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
  setup.kept_legs = read_kept_legs(files.plan.file);
  setup.make_host = [catalog = files.catalog] { return std::make_unique<LuaHost>(*catalog); };
  return setup;
}

std::string read_kept_legs(const std::string& plan_file) {
  const std::string file = plan_file + kept_legs_suffix;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
    return "";
  }
  const std::string bytes = read_file(file).value_or("");
  const std::string stamp = program_stamp();
  return bytes.starts_with(stamp) ? bytes.substr(stamp.size()) : "";
}

std::vector<Fault> kept_legs_advice(const std::string& plan_file) {
  const std::string file = plan_file + kept_legs_suffix;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored) || std::filesystem::is_regular_file(file, ignored)) {
    return {};
  }
  return {{Severity::warning,
           {file, 0},
           "it is no file: planned ways would be kept under this name, and are not"}};
}

std::vector<Fault> keep_legs(const std::string& plan_file, const std::string& bytes) {
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(plan_file, ignored);  // no pipe
  if (bytes.empty() || !is_file || !kept_legs_advice(plan_file).empty()) return {};
  try {
    write_file(plan_file + kept_legs_suffix, program_stamp() + bytes);
    return {};
  } catch (const std::runtime_error& error) {
    return {{Severity::warning,
             {},
             fmt::format("planned routes are not kept for the next run: {}", error.what())}};
  }
}

std::map<std::string, std::string> run_values(const MissionFiles& files,
                                              const Simulation& simulation) {
  const MissionInfo& mission = files.plan.mission;
  std::map<std::string, std::string> values{
      {"program", "lsos-host"},
      {"program_version", program_version},
      {"plan_sha256", files.plan.hash()},
      {"seed", std::to_string(mission.seed)},
      {"planet", std::string(mission.planet->name)},
      {"start_time", format_utc(mission.start_time)},
      {"log_interval_s", fmt::format("{}", seconds(mission.log_interval))},
      {"parked_log_interval_s", fmt::format("{}", seconds(mission.parked_log_interval))},
      {"terrain", files.terrain.name},
      {"terrain_sha256", simulation.ground().hash()},
      {"soil", files.terrain.soil.name},
  };
  if (files.terrain.beyond) values["terrain_beyond"] = files.terrain.beyond->name;
  if (!simulation.renderer().empty()) values["renderer"] = simulation.renderer();
  const ScriptUse use(*files.catalog, files.plan, files.terrain);
  for (const Script& script : files.catalog->scripts()) {
    if (!use.has(script)) continue;
    constexpr const char* kinds[] = {"event", "rover", "terrain", "soil"};
    values[fmt::format("{}_{}_sha256", kinds[static_cast<int>(script.kind)], script.name)] =
        script.sha256;
  }
  return values;
}

}  // namespace lsos
