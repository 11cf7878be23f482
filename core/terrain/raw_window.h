// Raster samples as a tile of heights, with what a smooth surface needs beyond edges and holes.
#pragma once

#include "terrain/height_tile.h"

class GDALRasterBand;

namespace lsos {

struct HeightScale {
  double scale = 1;
  double offset_m = 0;
};

// Heights of a band; missing where the band's mask (nodata, alpha) says so and where a sample is
// not finite. There is ground in each cell between four nodes that exist, where the outermost
// rows and columns continue linearly by one cell. Nodes missing next to such cells are filled by
// linear continuation, the mean of all directions that offer one: a pure function of the raster,
// so that all cells around a filled node see the same height and the surface stays C1.
// `goes_around`: the first column follows the last.
HeightTile raster_tile(const TileKey& key, GDALRasterBand& band, const HeightScale& scale,
                       bool goes_around);

}  // namespace lsos
