#include "lua/edit/kept_ground.h"

#include <fmt/format.h>

#include <algorithm>

#include "edit/coordinates.h"
#include "plan/kml_reader.h"
#include "plan/mission_reader.h"
#include "planet/place_text.h"

namespace lsos {

namespace {

constexpr double same_place_m = 1e-4;

bool is_tilted(const Surface& layer) {
  const auto* plane = std::get_if<PlaneSurface>(&layer);
  return plane != nullptr && plane->slope_rad != 0;
}

// A tilted plane has its height from the site, also beyond a raster.
bool has_tilt(const TerrainSpec& terrain) { return std::ranges::any_of(terrain.layers, is_tilted); }

// Whether the ground goes with the site for sure.
bool is_laid_out(const TerrainSpec& terrain) {
  const bool is_plane = std::ranges::all_of(terrain.layers, [](const Surface& layer) {
    return std::holds_alternative<PlaneSurface>(layer);
  });
  return has_tilt(terrain) || (is_plane && terrain.detail);
}

// Whether it may: what lies about a relief does not, what lies about a raster where that is wide.
bool may_go_with_site(const TerrainSpec& terrain) {
  const bool has_relief = std::ranges::any_of(terrain.layers, [](const Surface& layer) {
    return std::holds_alternative<ReliefSurface>(layer);
  });
  return has_tilt(terrain) || (!has_relief && terrain.detail);
}

bool is_same_ground(const MissionInfo& a, const MissionInfo& b) {
  return a.planet == b.planet && a.terrain.name == b.terrain.name;
}

}  // namespace

std::string keep_ground(PlanDocument& document, const MissionFiles& files) {
  if (!may_go_with_site(files.terrain)) return "";
  const std::string& file = files.plan.file;
  Faults told_later;
  const Plan changed =
      read_plan(file, parse_kml(document.text(), file), document.declarations(), told_later);
  if (changed.rovers.empty() || !is_same_ground(changed.mission, files.plan.mission)) return "";
  const Geodetic &before = site_of(files.plan), &now = site_of(changed);
  const bool has_moved = surface_distance_m(*files.plan.mission.planet, before, now) > same_place_m;
  if (!has_moved || changed.mission.site) return "";
  if (files.plan.mission.site) {
    return fmt::format("without {} generated ground is laid out from where the first rover starts",
                       site_field);
  }
  keep_site(document);
  return fmt::format("{} = {} keeps the ground where it was", site_field, lon_lat_text(before));
}

std::string moved_ground(const MissionFiles& taken_up, const Plan& into) {
  const Geodetic &there = site_of(taken_up.plan), &here = site_of(into);
  const double moved_m = surface_distance_m(*into.mission.planet, there, here);
  if (!is_laid_out(taken_up.terrain) || moved_m <= same_place_m) return "";
  return fmt::format(
      "{}: the ground of {} was laid out from {}, and is from {} now, {} away, as in {}: "
      "generated slopes, craters and rocks lie elsewhere for its rovers",
      taken_up.plan.file, taken_up.terrain.name, lon_lat_text(there), lon_lat_text(here),
      moved_m < 10 ? fmt::format("{:.2g} m", moved_m) : fmt::format("{:.0f} m", moved_m),
      into.file);
}

}  // namespace lsos
