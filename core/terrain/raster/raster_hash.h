// Samples of a raster as part of a terrain's hash.
#pragma once

#include "base/sha256.h"

class GDALRasterBand;

namespace lsos {

// Adds size, type, nodata value and samples, in the raster's own blocks. At most 2^23 cells
// are read, in blocks spread evenly over a larger raster, and the file's size is then added: a hash
// that took minutes would be switched off, and a changed raster differs in many blocks.
void add_samples(GDALRasterBand& band, Sha256& hash);
// The same for an overview, of which at most a fourth as many cells are read.
void add_overview(GDALRasterBand& band, Sha256& hash);

// Where add_samples() does not read all, adds the file's time of change and size.
void add_change(GDALRasterBand& band, Sha256& hash);

}  // namespace lsos
