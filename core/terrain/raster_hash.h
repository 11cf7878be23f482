// The samples of a raster in a terrain's hash.
#pragma once

#include "base/sha256.h"

class GDALRasterBand;

namespace lsos {

// Size, type, nodata value and samples, in the raster's own blocks. Of rasters with more than
// 2^26 cells only every n-th block is read, n as small as keeps to that many: a hash that took
// minutes would be switched off, and a changed raster differs in more than a few blocks.
void add_samples(GDALRasterBand& band, Sha256& hash);

}  // namespace lsos
