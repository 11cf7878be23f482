#include "terrain/spec/terrain_beyond.h"

#include <fmt/format.h>

#include <filesystem>

namespace lsos {

TerrainSpec raster_terrain(const RasterSurface& raster, const Place& place) {
  TerrainSpec terrain;
  terrain.name = std::filesystem::path(raster.file).filename();
  terrain.place = place;
  terrain.layers = {raster};
  terrain.is_synthetic = false;
  return terrain;
}

bool has_end(const TerrainSpec& terrain) {
  return std::holds_alternative<RasterSurface>(terrain.layers.back());
}

TerrainSpec with_beyond(TerrainSpec terrain, const TerrainSpec& beyond) {
  if (!has_end(terrain)) {
    throw InputError(terrain.place,
                     fmt::format("terrain {} is generated and has no end, so that nothing of {} "
                                 "would lie beyond it; a raster has one",
                                 terrain.name, beyond.name));
  }
  if (!terrain.planet.empty() && !beyond.planet.empty() && terrain.planet != beyond.planet) {
    throw InputError(terrain.place,
                     fmt::format("terrain {} lies on {}, terrain {} beyond it on {}", terrain.name,
                                 terrain.planet, beyond.name, beyond.planet));
  }
  terrain.beyond =
      TerrainBeyond{beyond.name, terrain.layers.size(), !terrain.detail && beyond.detail};
  terrain.layers.insert(terrain.layers.end(), beyond.layers.begin(), beyond.layers.end());
  if (terrain.planet.empty()) {
    terrain.planet = beyond.planet;
    terrain.beyond->names_planet = true;
  }
  if (!terrain.detail) terrain.detail = beyond.detail;
  if (!terrain.soil.name.empty()) return terrain;
  terrain.soil = beyond.soil;
  terrain.soil_patches = beyond.soil_patches;
  terrain.rock_soil = beyond.rock_soil;
  terrain.optical_depth = beyond.optical_depth;
  terrain.albedo = beyond.albedo;
  return terrain;
}

}  // namespace lsos
