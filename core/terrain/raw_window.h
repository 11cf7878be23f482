// Raster samples as a tile of heights, with what a smooth surface needs beyond edges and holes.
#pragma once

#include "terrain/height_tile.h"
#include "terrain/raster.h"

namespace lsos {

// Heights of a raster; missing where it says so. There is ground in each cell between four nodes
// that exist, where the outermost rows and columns continue linearly by one cell. Nodes missing
// next to such cells are filled by linear continuation, the mean of all directions that offer one:
// a pure function of the raster, so that all cells around a filled node see the same height and the
// surface stays C1. Where the raster goes around the body the first column follows the last.
HeightTile raster_tile(const TileKey& key, const Raster& raster);

}  // namespace lsos
