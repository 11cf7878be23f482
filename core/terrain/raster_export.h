// Heights as a file that every GIS opens.
#pragma once

#include <functional>
#include <string>

#include "terrain/map_grid.h"

namespace lsos {

struct RasterExport {
  std::string file;
  bool is_hillshade = false;  // a picture of them, lit from the north-west as gdaldem has it
};

// Writes a cloud-optimised GeoTIFF with CRS: heights in m, missing where `height_m` answers NaN, as
// 32-bit numbers. Under another name until it is whole. Throws InputError when it cannot be
// written.
void write_raster(const RasterExport& to, const MapGrid& grid, const Body& body,
                  const std::function<double(const Geodetic&)>& height_m);

}  // namespace lsos
