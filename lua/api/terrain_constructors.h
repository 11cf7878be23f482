// Value of lsos.terrain: the specification, whose soils may still be names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lua/runtime/reader.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

inline constexpr const char* terrain_kind = "terrain";
inline constexpr const char* soil_kind = "soil";

// A soil in a terrain script: the soil itself, or the name of a script in terrain/soils/.
struct SoilChoice {
  std::string name;  // "": `soil` holds the soil
  Soil soil;
};

struct SoilPatchScript {
  SoilPatch patch;  // raster files as the script names them
  SoilChoice soil;
};

struct TerrainScript {
  TerrainSpec spec;  // without soils; raster files as the script names them
  SoilChoice soil;
  std::optional<SoilChoice> rock_soil;
  std::vector<SoilPatchScript> soil_patches;
};

// Reads the keys of lsos.soil, also from a plain table.
void read_soil(TableReader& t, Soil& soil);

}  // namespace lsos
