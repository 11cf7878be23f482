// What lsos.terrain makes: the specification, whose soil may still be a name.
#pragma once

#include <string>

#include "lua/reader.h"
#include "terrain/terrain_spec.h"

namespace lsos {

inline constexpr const char* terrain_kind = "terrain";
inline constexpr const char* soil_kind = "soil";

struct TerrainScript {
  TerrainSpec spec;       // raster files as the script names them
  std::string soil_name;  // of a script in terrain/soils/; "": the spec has its soil
  std::string doc;
};

// The keys of lsos.soil, also for a plain table.
void read_soil(TableReader& t, Soil& soil);

}  // namespace lsos
