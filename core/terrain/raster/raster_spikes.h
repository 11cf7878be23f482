// Single cells of a raster that stand out of the ground about them as no rock does.
#pragma once

#include <string>

#include "terrain/grid/height_grid.h"
#include "terrain/raster/raster.h"

namespace lsos {

// Warns of spikes left by missing samples, clouds and faults in matching. Examines all of a small
// raster and a spread of windows of a large one; "" for good ones.
std::string spike_advice(const Raster& raster, const RasterSurface& surface, const HeightGrid& grid,
                         const Body& body);

}  // namespace lsos
