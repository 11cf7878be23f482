// The terrain that an instrument is asked about: a script by name, or a raster file.
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
  // Of a raster alone; a script says its own.
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
  // That of the finest raster; null without one.
  const RasterReader* reader() const { return readers.empty() ? nullptr : readers.front().get(); }
  const Body* body = nullptr;  // the reader's own, or one of all_bodies()
};

// Throws InputError: no such script or raster, options that do not fit it, an unknown planet.
TerrainSource terrain_source(const TerrainOptions& options);

// Its ground about a site: on its surface there, as a run has it; on the reference surface where
// there is none.
std::unique_ptr<Ground> ground_of(const TerrainSource& source, const Geodetic& site,
                                  std::uint64_t seed);
// Prints what is to be told of its rasters: units that are in doubt, overviews that are missing.
void print_advice(const Ground& ground);
// Of its finest raster.
Geodetic middle(const TerrainSource& source);

// The grid of a map: of the window at that resolution, or of the finest raster. `values`: that are
// held of each cell.
MapGrid map_grid(const TerrainSource& source, const std::optional<MapWindow>& window,
                 const std::optional<double>& resolution_m, int values = 1);
// About as long as a cell's shorter side, in its middle; 1 mm at least, and a hundredth of the
// longer side.
double cell_m(const MapGrid& grid, const Body& body);
// Faults of --resolution.
void check_resolution(const TerrainOptions& options, Faults& faults);
// Throws InputError: without a raster there is none, and both options are wanted.
void check_grid(const TerrainSource& source, const std::optional<MapWindow>& window,
                const std::optional<double>& resolution_m);

}  // namespace lsos
