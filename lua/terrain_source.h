// The terrain that an instrument is asked about: a script by name, or a raster file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lua/commands.h"
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

}  // namespace lsos
