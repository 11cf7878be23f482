// The samples of a raster in a terrain's hash.
#pragma once

#include "base/sha256.h"

class GDALRasterBand;

namespace lsos {

// Size, type, nodata value and samples, in the raster's own blocks. Of rasters with more than
// 2^23 cells only that many are read, in blocks spread evenly, and the file's size counts too: a
// hash that took minutes would be switched off, and a changed raster differs in more than a few
// blocks.
void add_samples(GDALRasterBand& band, Sha256& hash);
// The same of an overview, of which a fourth as many cells are read at most.
void add_overview(GDALRasterBand& band, Sha256& hash);

// Where add_samples() does not read all: when the file was changed, and how large it is.
void add_change(GDALRasterBand& band, Sha256& hash);

}  // namespace lsos
