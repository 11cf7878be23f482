// Raster samples as a tile of heights, with what a smooth surface needs beyond edges and holes.
#pragma once

#include "terrain/grid/height_tile.h"
#include "terrain/raster/raster.h"

namespace lsos {

// Tile of a raster's heights. There is ground in each cell between four nodes that exist, where the
// outermost rows and columns continue linearly by one cell. Nodes missing next to such cells are
// filled by linear continuation, the mean of all directions that offer one: a pure function of the
// raster, so that all cells around a filled node see the same height and the surface stays C1.
// Where the raster goes around the body the first column follows the last. A level above 0 has
// every 2^level-th column and row, from the file's overviews where there are any.
HeightTile raster_tile(const TileKey& key, const Raster& raster);

// The raster's samples at the nodes, NaN where they are missing and beyond its edges: for classes,
// between which there is nothing to interpolate.
HeightTile raw_tile(const TileKey& key, const Raster& raster);

}  // namespace lsos
