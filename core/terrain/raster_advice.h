// Rasters that work, but slowly.
#pragma once

#include <string>

class GDALRasterBand;

namespace lsos {

// What whoever has this raster should do about it: "raster 'FILE' has ..."; "" for nothing.
std::string raster_advice(GDALRasterBand& band, const std::string& file);

}  // namespace lsos
