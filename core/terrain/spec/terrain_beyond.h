// Terrains that end, and what is laid around them.
#pragma once

#include "terrain/spec/terrain_spec.h"

namespace lsos {

// Terrain of one raster: heights, and no soil, whose name stays empty.
TerrainSpec raster_terrain(const RasterSurface& raster, const Place& place);

// Whether the terrain's ground ends somewhere: a raster does, generated ground does not.
bool has_end(const TerrainSpec& terrain);

// Returns `terrain` with `beyond` where it ends. Each keeps its own detail; where both have some,
// that of `terrain` serves for both. Soil, soil patches and air are those of `terrain`, or of
// `beyond` where `terrain` is a raster alone. Throws InputError at the terrain's place: it has no
// end, or the two lie on different bodies.
TerrainSpec with_beyond(TerrainSpec terrain, const TerrainSpec& beyond);

}  // namespace lsos
