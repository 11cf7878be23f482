// The terrain of an instrument's options: a script by name, or a raster file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lua/app/instrument_answer.h"
#include "terrain/ground.h"
#include "terrain/raster/map_grid.h"
#include "terrain/raster/raster_reader.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

// Which terrain an instrument is asked about, and which part of it.
struct TerrainOptions {
  std::string name;    // of a terrain script, or a raster
  std::string beyond;  // the same, where that one ends; "": none
  // These describe a raster alone; a script says its own.
  std::string band;  // its number or description
  std::optional<double> nodata;
  std::string unit;
  std::optional<bool> is_radius;
  std::string crs;

  std::string planet;           // of a script without a raster; "": Moon
  std::string site;             // "LON,LAT"; "": the first of `at`, or the window's centre
  std::uint64_t seed = 0;       // of generated ground
  std::vector<std::string> at;  // "LON,LAT"
  std::string export_file;
  std::string window;  // "LON0,LAT0,LON1,LAT1"
  std::optional<double> resolution_m;
  bool is_hillshade = false;
  AnswerStyle style = AnswerStyle::by_output;
};

struct TerrainSource {
  TerrainSpec spec;
  bool is_script = false;
  std::vector<std::unique_ptr<RasterReader>> readers;  // of its rasters, fine to coarse
  // Reader of the finest raster; nullptr without rasters.
  const RasterReader* reader() const { return readers.empty() ? nullptr : readers.front().get(); }
  const Body* body = nullptr;  // the reader's own, or one of all_bodies()
};

// Throws InputError for a script or raster that does not exist, options that do not fit it, or an
// unknown planet.
TerrainSource terrain_source(const TerrainOptions& options);

// Ground of the terrain about a site. The site's origin is on the surface there, as in a run, or on
// the reference surface where there is no ground.
std::unique_ptr<Ground> ground_of(const TerrainSource& source, const Geodetic& site,
                                  std::uint64_t seed);
// Says about which site seeded features are placed, where the user has named none.
void print_default_site(const TerrainSource& source, const Geodetic& site);
// Prints warnings about the rasters: units that are in doubt, overviews that are missing.
void print_advice(const Ground& ground);
// Centre of the finest raster.
Geodetic middle(const TerrainSource& source);

// Grid of a map: that of the window at the given resolution, or that of the finest raster.
// `values`: number of values held for each cell.
MapGrid map_grid(const TerrainSource& source, const std::optional<MapWindow>& window,
                 const std::optional<double>& resolution_m, int values = 1);
// Approximate length of the shorter side of the cell in the grid's middle; at least 1 mm and a
// hundredth of the longer side.
double cell_m(const MapGrid& grid, const Body& body);
// Adds the faults of --resolution.
void check_resolution(const TerrainOptions& options, Faults& faults);
// Throws InputError where the terrain has no raster, whose grid could be used, and --window and
// --resolution are not both given.
void check_grid(const TerrainSource& source, const std::optional<MapWindow>& window,
                const std::optional<double>& resolution_m);

}  // namespace lsos
