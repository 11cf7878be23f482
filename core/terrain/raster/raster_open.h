// Opening a raster: the file, its band, its CRS and geotransform, and what its samples mean.
#pragma once

#include <array>
#include <memory>

#include "terrain/raster/height_band.h"
#include "terrain/raster/raster_name.h"
#include "terrain/spec/raster_surface.h"

#include "planet/body.h"

class GDALDataset;
class OGRSpatialReference;

namespace lsos {

// All of these refuse, by InputError, what cannot serve as heights, or classes, of a known place.
std::unique_ptr<GDALDataset> open_raster(const RasterSurface& surface, const RasterName& name);
GDALRasterBand& chosen_band(GDALDataset& dataset, const RasterSurface& surface,
                            const RasterName& name);
// CRS without a vertical part; x is east or longitude.
OGRSpatialReference crs_of(GDALDataset& dataset, const RasterSurface& surface,
                           const RasterName& name);
std::array<double, 6> geotransform_of(GDALDataset& dataset, const RasterName& name);
// Whether the user, the band or its CRS says what unit the heights have.
bool names_unit(GDALRasterBand& band, const RasterSurface& surface);
// Heights of a band, or a refusal; classes are taken as they are written, whatever they are.
HeightBand interpret_band(GDALRasterBand& band, const RasterSurface& surface, const Body& body,
                          const RasterName& name);

}  // namespace lsos
