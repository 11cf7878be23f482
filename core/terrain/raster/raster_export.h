// Export of heights to a file that every GIS opens.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "terrain/raster/map_grid.h"

namespace lsos {

struct RasterExport {
  std::string file;
  bool is_hillshade = false;  // the file is a hillshade, lit from the north-west as by gdaldem
};

struct MapBand {
  std::string name;
  std::string unit;  // "": none
};

// Writes a cloud-optimised GeoTIFF with CRS: heights in m, as 32-bit numbers, missing where
// `height_m` returns NaN. Throws as write_file() does.
void write_raster(const RasterExport& to, const MapGrid& grid, const Body& body,
                  const std::function<double(const Geodetic&)>& height_m);

// Writes a map of any values: `values` gets the places of a row, absent where the map has none, and
// returns one value for each band and place, band after band.
using MapRow = std::function<std::vector<double>(std::span<const std::optional<Geodetic>>)>;
void write_map(const std::string& file, const MapGrid& grid, const Body& body,
               const std::vector<MapBand>& bands, const MapRow& values);

}  // namespace lsos
