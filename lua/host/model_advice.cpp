#include "lua/host/model_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <set>
#include <string>
#include <vector>

#include "lua/host/script_folders.h"
#include "mission/model/model_doubts.h"
#include "planet/body.h"

namespace lsos {

namespace {

std::string without_full_stop(const std::string& sentence) {
  return sentence.ends_with('.') ? sentence.substr(0, sentence.size() - 1) : sentence;
}

constexpr const char* depends_on_soil =
    "slip, sinkage, the energy of driving and planned routes depend on it";

bool drives_elsewhere_than_on_the_moon(const MissionFiles& files) {
  const Body* planet = files.plan.mission.planet;
  const auto drives = [&](const PlanEvent& event) {
    return event.is_enabled && files.catalog->declarations().events.at(event.type).drives;
  };
  return planet != nullptr && planet->id != BodyId::moon &&
         std::ranges::any_of(files.plan.events, drives);
}

// Warns of driving elsewhere on lunar soil: shipped terrains for any planet have the Moon's
// regolith.
void say_lunar_soil(MissionFiles& files) {
  const TerrainSpec& terrain = files.terrain;
  const bool is_lunar = terrain.soil.name.starts_with("Apollo");
  // The author of any other script has chosen its soil.
  const auto is_shipped = [&](const Script& script) {
    return script.kind == ScriptKind::terrain && script.name == terrain.name &&
           script.folder.starts_with(shipped_scripts());
  };
  if (std::ranges::none_of(files.catalog->scripts(), is_shipped)) return;
  if (files.is_soil_assumed || !is_lunar || !drives_elsewhere_than_on_the_moon(files)) return;
  files.faults.warning(
      files.plan.mission.place,
      fmt::format("MissionInfo: {}: its soil is {} ({}), on {}; {}; a terrain script can name "
                  "another",
                  terrain.name, terrain.soil.name, without_full_stop(terrain.soil.doc),
                  files.plan.mission.planet->name, depends_on_soil));
}

// Records the assumed soil, and warns where it matters: regolith is similar all over the Moon, but
// on Mars and Earth every drive depends on the choice.
void say_assumed_soil(MissionFiles& files) {
  if (!files.is_soil_assumed) return;
  const MissionInfo& mission = files.plan.mission;
  const std::string assumed =
      fmt::format("{}: nothing says what the ground is made of; {} is assumed", files.terrain.name,
                  files.terrain.soil.name);
  files.assumptions.push_back(assumed + "; a terrain script can name another");
  if (!drives_elsewhere_than_on_the_moon(files)) return;
  files.faults.warning(
      mission.place,
      fmt::format("MissionInfo: {}, as anywhere on {} ({}); {}; a terrain script can name another",
                  assumed, mission.planet->name, without_full_stop(files.terrain.soil.doc),
                  depends_on_soil));
}

void say_doubts(MissionFiles& files) {
  const auto say = [&](const Place& place, const std::string& of,
                       const std::vector<std::string>& doubts) {
    for (const std::string& doubt : doubts) {
      files.faults.warning(place, of.empty() ? doubt : fmt::format("{}: {}", of, doubt));
    }
  };
  for (const auto& [name, model] : files.rover_models) {
    say(model.spec.place, name, rover_doubts(model));
  }
  for (const auto& [name, model] : files.asset_models) say(model.place, name, asset_doubts(model));
  const TerrainSpec& terrain = files.terrain;
  std::set<std::string> reported;
  const auto say_soil = [&](const Soil& soil) {
    if (!soil.name.empty() && reported.insert(soil.name).second) {
      say(terrain.place, "", soil_doubts(soil));
    }
  };
  say_soil(terrain.soil);
  if (terrain.rock_soil) say_soil(*terrain.rock_soil);
  for (const SoilPatch& patch : terrain.soil_patches) say_soil(patch.soil);
}

bool is_near(const SoilPatch& patch, const Body& body, const Geodetic& place) {
  constexpr double near_m = 100e3;
  using LonLat = std::pair<double, double>;
  const auto corner_m = [&](const LonLat& corner) {
    return surface_distance_m(body, geodetic_from_degrees(corner.first, corner.second), place);
  };
  if (std::ranges::any_of(patch.lon_lat_deg, [&](const auto& c) { return corner_m(c) < near_m; })) {
    return true;
  }
  // The place may lie inside a patch whose corners are farther away.
  const auto& corners = patch.lon_lat_deg;
  const auto [west, east] = std::ranges::minmax_element(corners, {}, &LonLat::first);
  const auto [south, north] = std::ranges::minmax_element(corners, {}, &LonLat::second);
  const double lon = lon_deg(place), lat = lat_deg(place);
  return lon >= west->first && lon <= east->first && lat >= south->second && lat <= north->second;
}

// Warns where all patches of soil are far from the rovers, as with longitude and latitude
// exchanged.
void say_far_patches(MissionFiles& files) {
  const TerrainSpec& terrain = files.terrain;
  const Body* body = files.plan.mission.planet;
  if (body == nullptr || terrain.soil_patches.empty()) return;
  for (const SoilPatch& patch : terrain.soil_patches) {
    if (patch.raster || patch.lon_lat_deg.empty()) return;
    for (const PlanRover& rover : files.plan.rovers) {
      if (is_near(patch, *body, rover.start)) return;
    }
  }
  const auto& [lon, lat] = terrain.soil_patches.front().lon_lat_deg.front();
  files.faults.warning(
      terrain.place,
      fmt::format("soil_patches: none is within 100 km of a rover; the first begins at longitude "
                  "{:g}, latitude {:g}: are they exchanged?",
                  lon, lat));
}

}  // namespace

void add_model_advice(MissionFiles& files, bool is_soil_given) {
  if (!is_soil_given) {
    say_assumed_soil(files);
    say_lunar_soil(files);
  }
  say_doubts(files);
  if (!files.faults.has_errors()) say_far_patches(files);
}

}  // namespace lsos
