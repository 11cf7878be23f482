// lsos.raster: a file of heights, with settings that the file does not contain.
#pragma once

#include "lua/runtime/reader.h"
#include "terrain/spec/raster_surface.h"

namespace lsos {

void read_raster(TableReader& t, RasterSurface& raster);

}  // namespace lsos
