// What to tell the user of a raster that can be read, and yet.
#pragma once

#include <string>

#include "terrain/grid/height_grid.h"
#include "terrain/raster/raster.h"

namespace lsos {

// Asked to show large areas, a large raster without overviews that may be used is read whole. ""
// for good ones.
std::string overview_advice(const HeightBand& heights, const std::string& file);

// Heights that differ by no more than no ground does over such a distance, of a raster that names
// no unit: in km, more often than not. "" for good ones.
std::string unit_advice(const Raster& raster, const RasterSurface& surface, const HeightGrid& grid,
                        const Body& body);

// Heights that the body has nowhere (Moon: Smith et al. 2010, LOLA; Mars: Smith et al. 2001, MOLA,
// its poles above a sphere; Earth: Challenger Deep and Everest), of which the user has not said the
// unit. "" for good ones.
std::string extreme_advice(const Raster& raster, const RasterSurface& surface, const Body& body);

// Heights in whole numbers on cells so small that the steps between them are slopes. "" for good
// ones.
std::string step_advice(const Raster& raster, const RasterSurface& surface, const HeightGrid& grid,
                        const Body& body);

// Samples of 8 bits that name no unit: a picture, more often than not. "" for others.
std::string picture_advice(const Raster& raster, const RasterSurface& surface);

// Several bands without descriptions, of which the user has named none. "" for others.
std::string band_advice(const Raster& raster, const RasterSurface& surface);

// Samples of exactly 0 far from all others: warping fills so what it does not know. "" for others.
std::string zero_advice(const Raster& raster, const RasterSurface& surface);

// A band or file whose name says that it holds something else than heights. "" for others.
std::string word_advice(const Raster& raster, const RasterSurface& surface);

// Cells more than this many times as long as wide make no ground to drive on: what is told apart
// along a parallel lies within a wheel's width, and next to the pole every column has a height of
// its own for the same place. In longitude and latitude cells are so from 87.1 degrees on.
inline constexpr double sliver_aspect = 20;
// "" where the raster's cells at the place are not slivers.
std::string sliver_text(const RasterSurface& surface, const HeightGrid& grid, const Body& body,
                        const Geodetic& place);

// On larger cells a rover drives over ground of which nothing is known.
inline constexpr double drivable_cell_max_m = 50;
// "" for cells that show what a rover drives over.
std::string coarse_text(const RasterSurface& surface, double cell_m);

}  // namespace lsos
