// `lsos-host terrain`: the ground on its own, so that an engineer can check it or map it.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/output_file.h"
#include "base/rounding.h"
#include "base/units.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/place_options.h"
#include "lua/app/terrain_source.h"
#include "mission/model/site.h"
#include "terrain/ground.h"
#include "terrain/raster/raster_export.h"
#include "terrain/spec/raster_layers.h"

namespace lsos {

namespace {

struct TerrainQuestion {
  std::vector<Geodetic> places;
  std::optional<Geodetic> site;
  std::optional<MapWindow> window;
};

void check_export(const TerrainOptions& options, Faults& faults) {
  const bool is_export = !options.export_file.empty();
  const auto needs_export = [&](const char* option, bool is_given) {
    if (is_given && !is_export) {
      faults.error({}, fmt::format("{}: says how to export; --export OUT.tif is missing", option));
    }
  };
  needs_export("--window", !options.window.empty());
  needs_export("--resolution", options.resolution_m.has_value());
  needs_export("--hillshade", options.is_hillshade);
  if (!is_export && options.at.empty()) {
    faults.error({}, "terrain: nothing is requested; give --at LON,LAT or --export OUT.tif");
  }
  check_resolution(options, faults);
}

// Reads the options. Throws InputError with all faults at once.
TerrainQuestion terrain_question(const TerrainOptions& options) {
  Faults faults;
  TerrainQuestion question;
  for (const std::string& text : options.at) {
    if (const auto place = option_place("--at", text, faults)) question.places.push_back(*place);
  }
  if (!options.site.empty()) question.site = option_place("--site", options.site, faults);
  if (!options.window.empty()) question.window = option_window(options.window, faults);
  check_export(options, faults);
  check_output("--export", options.export_file, {".tif", ".tiff"}, {options.name}, faults);
  faults.throw_if_errors();
  if (!question.site && !question.places.empty()) question.site = question.places.front();
  if (!question.site && question.window) question.site = question.window->centre();
  return question;
}

AnswerRow or_null(const std::optional<double>& value) {
  return value ? AnswerRow(computed(*value)) : AnswerRow(nullptr);
}

AnswerRow degrees_or_null(const std::optional<double>& angle_rad) {
  return angle_rad ? AnswerRow(computed(degrees(*angle_rad))) : AnswerRow(nullptr);
}

// Adds the ground as wheels meet it: its height, and its normal as east, north and up at the place.
void add_ground_fields(const Ground& ground, const Geodetic& place, AnswerRow& fields) {
  fields["height_m"] = nullptr;
  fields["normal"] = nullptr;
  fields["surface_slope_deg"] = nullptr;
  const std::optional<double> height_m = ground.elevation_m(place);
  if (!height_m) return;
  fields["height_m"] = computed(*height_m);
  const SiteFrame& site = ground.site();
  const Vec3 p_S_m = site.p_S_m({place.lon_rad, place.lat_rad, *height_m});
  const GroundSample sample = Ground::Probe(ground).sample(p_S_m);
  if (!sample.is_ground()) return;
  const double east = sample.normal_S.dot(site.east_S(p_S_m));
  const double north = sample.normal_S.dot(site.north_S(p_S_m));
  const double up = sample.normal_S.dot(site.up_S(p_S_m));
  fields["normal"] = {computed(east), computed(north), computed(up)};
  fields["surface_slope_deg"] = computed(degrees(std::atan2(std::hypot(east, north), up)));
}

AnswerRow point_of(const TerrainSource& source, const Ground& ground, const Geodetic& place) {
  AnswerRow fields{{"lon_deg", entered_deg(lon_deg(place))},
                   {"lat_deg", entered_deg(lat_deg(place))}};
  std::optional<RasterPoint> raster;
  // The finest raster with a height there is used; without one, the finest raster that covers the
  // place.
  for (const auto& reader : source.readers) {
    const auto point = reader->at(place);
    if (!raster || (point && point->height_m)) raster = point;
    if (raster && raster->height_m) break;
  }
  const RasterPoint found = raster.value_or(RasterPoint{});
  fields["raster_height_m"] = or_null(found.height_m);
  add_ground_fields(ground, place, fields);
  fields["slope_deg"] = degrees_or_null(found.slope_rad);
  fields["aspect_deg"] = degrees_or_null(found.aspect_rad);
  fields["aspect_grid_deg"] = degrees_or_null(found.aspect_grid_rad);
  if (source.is_script) {
    const Vec3 p_S_m = ground.site().p_S_m({place.lon_rad, place.lat_rad, 0});
    fields["x"] = computed(p_S_m.x());
    fields["y"] = computed(p_S_m.y());
  } else {
    fields["x"] = raster ? AnswerRow(computed(raster->map.x)) : AnswerRow(nullptr);
    fields["y"] = raster ? AnswerRow(computed(raster->map.y)) : AnswerRow(nullptr);
  }
  fields["crs_unit"] = source.is_script ? "m" : source.reader()->crs_unit();
  fields["body"] = source.body->name;
  return fields;
}

AnswerRow exported(const TerrainSource& source, const Ground& ground,
                   const TerrainQuestion& question, const TerrainOptions& options) {
  const bool is_own_grid = !options.resolution_m;
  const MapGrid grid = map_grid(source, question.window, options.resolution_m);
  std::int64_t cells = 0;  // cells with ground
  // Next to missing samples the ground has no height; there the raster's own samples are used.
  write_raster({options.export_file, options.is_hillshade}, grid, *source.body,
               [&](const Geodetic& place) {
                 std::optional<double> height_m =
                     ground.elevation_m(place, options.resolution_m.value_or(0));
                 if (!height_m && is_own_grid) {
                   if (const auto point = source.reader()->at(place)) height_m = point->height_m;
                 }
                 if (height_m) ++cells;
                 return height_m.value_or(std::numeric_limits<double>::quiet_NaN());
               });
  return {{"file", options.export_file},
          {"columns", grid.columns},
          {"rows", grid.rows},
          {"cells_without_value", std::int64_t{grid.columns} * grid.rows - cells}};
}

int terrain_command(const TerrainOptions& options) {
  TerrainQuestion question = terrain_question(options);
  const TerrainSource source = terrain_source(options);
  const bool is_export = !options.export_file.empty();
  if (is_export) check_grid(source, question.window, options.resolution_m);
  const bool is_given = !options.site.empty();
  if (!question.site) question.site = middle(source);
  if (!is_given) print_default_site(source, *question.site);
  const std::unique_ptr<Ground> ground = ground_of(source, *question.site, options.seed);
  print_advice(*ground);
  AnswerRow points = AnswerRow::array();
  for (const Geodetic& place : question.places) {
    // A place beyond the reach of the site's tangent plane gets its own site.
    const double away_rad =
        surface_distance_m(*source.body, place, *question.site) / source.body->equatorial_radius_m;
    constexpr double reach_rad = 0.9;
    const bool is_near = away_rad < reach_rad;
    points.push_back(is_near ? point_of(source, *ground, place)
                             : point_of(source, *ground_of(source, place, options.seed), place));
  }
  if (is_export) {
    const AnswerRow file = exported(source, *ground, question, options);
    if (question.places.empty()) points.push_back(file);
  }
  for (const AnswerRow& point : points) {
    if (!point.contains("height_m") || !point["height_m"].is_null()) continue;
    print_message(
        "warning: there is no ground at {},{}; the terrain does not reach there, or its "
        "samples are missing\n",
        point["lon_deg"].dump(), point["lat_deg"].dump());
  }
  print_answer(points, options.style);
  return 0;
}

}  // namespace

std::function<int()> prepare_terrain(CommandOptions& command) {
  const auto options = std::make_shared<TerrainOptions>();
  add_ground(command, *options);
  command.add_option("--at", options->at, "LON,LAT in degrees; may come more than once").repeated();
  command.add_option("--export", options->export_file, "Write heights as a GeoTIFF");
  command.add_flag("--hillshade", options->is_hillshade, "Export a hillshade, not heights");
  add_style(command, options->style);
  return [options] { return terrain_command(*options); };
}

}  // namespace lsos
