// Warnings about rasters that can be read, but may not be what they seem. Each is "" where there is
// nothing to warn of.
#pragma once

#include <string>

#include "terrain/grid/height_grid.h"
#include "terrain/raster/raster.h"

namespace lsos {

// A large raster without usable overviews, which maps of large areas read whole.
std::string overview_advice(const HeightBand& heights, const std::string& file);

// Heights that differ less than any ground does over such a distance, in a raster that names no
// unit: in km, more often than not.
std::string unit_advice(const Raster& raster, const RasterSurface& surface, const HeightGrid& grid,
                        const Body& body);

// Heights that the body has nowhere (Moon: Smith et al. 2010, LOLA; Mars: Smith et al. 2001, MOLA,
// its poles above a sphere; Earth: Challenger Deep and Everest), without a unit given by the user.
std::string extreme_advice(const Raster& raster, const RasterSurface& surface, const Body& body);

// Heights in whole numbers on cells so small that the steps between them are slopes.
std::string quantisation_advice(const Raster& raster, const RasterSurface& surface,
                                const HeightGrid& grid, const Body& body);

// Samples of 8 bits that name no unit: a picture, more often than not.
std::string picture_advice(const Raster& raster, const RasterSurface& surface);

// Several bands without descriptions, of which the user has named none.
std::string band_advice(const Raster& raster, const RasterSurface& surface);

// Samples of exactly 0 far from all others: warping fills unknown cells so.
std::string zero_advice(const Raster& raster, const RasterSurface& surface);

// A band or file whose name says that it holds something else than heights.
std::string name_advice(const Raster& raster, const RasterSurface& surface);

// Cells more than this many times as long as wide make no ground to drive on: what differs along a
// parallel lies within a wheel's width, and next to the pole every column has a height of its own
// for the same place. In longitude and latitude cells are so from 87.1 degrees on.
inline constexpr double sliver_aspect = 20;
// Reason why the raster's cells at the place are slivers; "" where they are not.
std::string sliver_text(const RasterSurface& surface, const HeightGrid& grid, const Body& body,
                        const Geodetic& place);

// Largest cells that show what a rover drives over, m.
inline constexpr double drivable_cell_max_m = 50;
// Reason why larger cells are too coarse; "" for others.
std::string coarse_text(const RasterSurface& surface, double cell_m);

}  // namespace lsos
