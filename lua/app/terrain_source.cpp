#include "lua/app/terrain_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "access/file_access.h"
#include "base/console.h"
#include "base/quantity.h"
#include "lua/app/place_options.h"
#include "lua/host/mission_reader.h"
#include "mission/model/site.h"
#include "terrain/spec/raster_layers.h"
#include "terrain/spec/terrain_beyond.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

RasterSurface surface_of(const TerrainOptions& options) {
  RasterSurface surface;
  surface.file = options.name;
  surface.is_band_given = !options.band.empty();
  if (const auto number = parse_integer(options.band)) {
    surface.band = static_cast<int>(std::clamp<std::int64_t>(*number.value, 0, 1'000'000));
  } else if (!options.band.empty()) {
    surface.band = options.band;
  }
  surface.nodata = options.nodata;
  surface.unit = options.unit;
  surface.is_radius = options.is_radius;
  surface.crs = options.crs;
  return surface;
}

void refuse_raster_options(const TerrainOptions& options) {
  const std::pair<const char*, bool> given[] = {{"--band", !options.band.empty()},
                                                {"--nodata", options.nodata.has_value()},
                                                {"--unit", !options.unit.empty()},
                                                {"--radius", options.is_radius.has_value()},
                                                {"--crs", !options.crs.empty()}};
  Faults faults;
  for (const auto& [option, is_given] : given) {
    if (!is_given) continue;
    faults.error({}, fmt::format("{}: is for a raster; the terrain script '{}' says in its "
                                 "lsos.raster how its own is read",
                                 option, options.name));
  }
  faults.throw_if_errors();
}

// Whether a name that is no script's is a raster: such a file exists, or the name looks like one,
// as GDAL also opens names that are no files.
bool is_raster_name(const std::string& name) {
  std::error_code ignored;
  return fs::exists(name, ignored) || name.find_first_of("/.:") != std::string::npos;
}

// Whether the catalog has a terrain script of that name, sound or broken.
bool is_script_of(const Catalog& catalog, const std::string& name) {
  return !catalog.faults_of(ScriptKind::terrain, name).empty() ||
         std::ranges::count(catalog.declarations().terrains, name) > 0;
}

// A terrain script by name, or the raster read with the settings of `surface`.
TerrainSpec named_terrain(const Catalog& catalog, const std::string& name,
                          const RasterSurface& surface) {
  const bool is_script = is_script_of(catalog, name);
  if (!is_script && name.ends_with(".lua")) {
    throw InputError({}, fmt::format("{} is a script: it is asked for by its name, {}, and found "
                                     "in terrain/ here, in LSOS_PATH or among the shipped ones",
                                     name, fs::path(name).stem().string()));
  }
  if (!is_script && is_raster_name(name)) {
    allow_raster(name);
    return raster_terrain(surface, {});
  }
  return catalog.load_terrain(name, {});
}

}  // namespace

TerrainSource terrain_source(const TerrainOptions& options) {
  TerrainSource source;
  Faults faults;
  const Body* planet =
      options.planet.empty() ? nullptr : option_body("--planet", options.planet, faults);
  faults.throw_if_errors();
  const auto catalog = read_catalog("");
  source.is_script = is_script_of(*catalog, options.name);
  source.spec = named_terrain(*catalog, options.name, surface_of(options));
  if (source.is_script) refuse_raster_options(options);
  if (!options.beyond.empty()) {
    source.spec = with_beyond(std::move(source.spec),
                              named_terrain(*catalog, options.beyond, {options.beyond}));
  }
  if (planet == nullptr && !source.spec.planet.empty()) planet = find_body(source.spec.planet);
  for (const RasterSurface& raster : rasters_of(source.spec)) {
    // All rasters lie on the body of the first.
    const Body* body =
        planet == nullptr && source.reader() != nullptr ? &source.reader()->own_body() : planet;
    source.readers.push_back(std::make_unique<RasterReader>(raster, source.spec.place, body));
  }
  source.body = planet != nullptr            ? planet
                : source.reader() != nullptr ? &source.reader()->own_body()
                                             : find_body("Moon");
  return source;
}

std::unique_ptr<Ground> ground_of(const TerrainSource& source, const Geodetic& site,
                                  std::uint64_t seed) {
  const SiteFrame datum(*source.body, {site.lon_rad, site.lat_rad, 0});
  auto ground = std::make_unique<Ground>(source.spec, datum, seed);
  if (!ground->elevation_m(site)) return ground;
  return ground_at(source.spec, *source.body, site, seed);
}

void print_default_site(const TerrainSource& source, const Geodetic& site) {
  const Detail& detail = source.spec.detail.value_or(Detail{});
  if (!source.is_script || !(detail.craters || detail.rocks || detail.roughness)) return;
  print_message(
      "{}: its craters, rocks and roughness are placed about a site, here {:.6g},{:.6g}, as no "
      "--site says which; a mission's is its SiteOrigin, or the start of its first rover\n",
      source.spec.name, lon_deg(site), lat_deg(site));
}

void print_advice(const Ground& ground) {
  for (const Fault& advice : ground.advice()) print_message("warning: {}\n", advice.what);
}

Geodetic middle(const TerrainSource& source) {
  const Raster& raster = source.reader()->raster();
  return raster.map().place({raster.columns() / 2.0, raster.rows() / 2.0}).value_or(Geodetic{});
}

MapGrid map_grid(const TerrainSource& source, const std::optional<MapWindow>& window,
                 const std::optional<double>& resolution_m, int values) {
  if (resolution_m) return grid_of_window(*source.body, *window, *resolution_m, values);
  const std::string file = rasters_of(source.spec).front().file;
  return grid_of_raster(source.reader()->raster(), window, {source.spec.place, file}, values);
}

double cell_m(const MapGrid& grid, const Body& body) {
  const RasterMap map = grid.map(body);
  const double column = grid.columns / 2.0, row = grid.rows / 2.0;
  const auto here = map.place({column, row});
  double least_m = std::numeric_limits<double>::infinity(), greatest_m = 0;
  for (const auto& next : {map.place({column + 1, row}), map.place({column, row + 1})}) {
    if (!here || !next) continue;
    const double side_m = surface_distance_m(body, *here, *next);
    least_m = std::min(least_m, side_m);
    greatest_m = std::max(greatest_m, side_m);
  }
  // At a pole of a map in degrees the columns converge.
  constexpr double smallest_m = 1e-3, smallest_share = 0.01;
  return greatest_m > 0 ? std::max({smallest_m, smallest_share * greatest_m, least_m}) : 1;
}

void check_resolution(const TerrainOptions& options, Faults& faults) {
  if (!options.resolution_m) return;
  if (!(std::isfinite(*options.resolution_m) && *options.resolution_m > 0)) {
    faults.error({}, fmt::format("--resolution {}: must be above 0 m", *options.resolution_m));
  }
  if (options.window.empty()) {
    faults.error({}, "--resolution: a --window LON0,LAT0,LON1,LAT1 is missing");
  }
}

void check_cells(const TerrainSource& source, const std::optional<MapWindow>& window,
                 const std::optional<double>& resolution_m) {
  if (!window || !resolution_m) return;
  const double height_m =
      radians(window->north_deg - window->south_deg) * source.body->equatorial_radius_m;
  if (*resolution_m <= height_m) return;
  throw InputError({}, fmt::format("--resolution {}: is more than the window's {:.4g} m from south "
                                   "to north, which would be one cell",
                                   *resolution_m, height_m));
}

void check_grid(const TerrainSource& source, const std::optional<MapWindow>& window,
                const std::optional<double>& resolution_m) {
  check_cells(source, window, resolution_m);
  if (source.reader() != nullptr || (window && resolution_m)) return;
  throw InputError({}, fmt::format("the terrain '{}' has no raster whose grid could be taken: "
                                   "--window LON0,LAT0,LON1,LAT1 and --resolution M are wanted",
                                   source.spec.name));
}

}  // namespace lsos
