// The rasters that a terrain is made of.
#pragma once

#include <vector>

#include "terrain/spec/terrain_spec.h"

namespace lsos {

// Rasters of a terrain from fine to coarse; none for generated ground.
inline std::vector<RasterSurface> rasters_of(const TerrainSpec& spec) {
  std::vector<RasterSurface> rasters;
  for (const Surface& layer : spec.layers) {
    if (const auto* raster = std::get_if<RasterSurface>(&layer)) rasters.push_back(*raster);
  }
  return rasters;
}

}  // namespace lsos
