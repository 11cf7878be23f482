// What lsos.terrain makes: the specification, whose soil may still be a name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lua/runtime/reader.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

inline constexpr const char* terrain_kind = "terrain";
inline constexpr const char* soil_kind = "soil";

// A soil in a terrain script: itself, or the name of a script in terrain/soils/.
struct SoilChoice {
  std::string name;  // "": `soil` is it
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

// The keys of lsos.soil, also for a plain table.
void read_soil(TableReader& t, Soil& soil);

}  // namespace lsos
