// The terrain that an instrument is asked about: a script by name, or a raster file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lua/commands.h"
#include "terrain/ground.h"
#include "terrain/map_grid.h"
#include "terrain/raster_reader.h"
#include "terrain/terrain_spec.h"

namespace lsos {

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
