// Heights as a file that every GIS opens.
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
  bool is_hillshade = false;  // a picture of them, lit from the north-west as gdaldem has it
};

struct MapBand {
  std::string name;
  std::string unit;  // "": none
};

// Writes a cloud-optimised GeoTIFF with CRS: heights in m, missing where `height_m` answers NaN, as
// 32-bit numbers. Under another name until it is whole. Throws InputError when it cannot be
// written.
void write_raster(const RasterExport& to, const MapGrid& grid, const Body& body,
                  const std::function<double(const Geodetic&)>& height_m);

// The same of anything: `values` of the places of a row answers a value a band and place, band
// after band; places that the map does not have are absent.
using MapRow = std::function<std::vector<double>(std::span<const std::optional<Geodetic>>)>;
void write_map(const std::string& file, const MapGrid& grid, const Body& body,
               const std::vector<MapBand>& bands, const MapRow& values);

}  // namespace lsos
