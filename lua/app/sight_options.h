// What `lsos-host sight` is asked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lua/app/terrain_source.h"

namespace lsos {

struct SightOptions {
  TerrainOptions terrain;          // of these name, raster, planet, site, seed, window, resolution
  std::string from;                // "LON,LAT,H", H above the ground
  std::vector<std::string> to;     // the same
  std::optional<double> height_m;  // of targets all over a map, above the ground
  std::string file;                // OUT.tif; "": no map
  bool is_flat = false;
  bool is_horizon = false;
  std::optional<double> step_deg;  // of the horizon's azimuths
  bool is_quiet = false;
  int threads = 1;
};

// A place given on the command line; its height is above the ground.
struct PlaceOption {
  std::string option;  // "--to 30,10,2"
  Geodetic place;
};

struct SightQuestion {
  std::optional<PlaceOption> from;
  std::vector<PlaceOption> to;
  double target_m = 0;
  std::optional<Geodetic> site;
  std::optional<MapWindow> window;
};

// Reads the options. Throws InputError with all faults at once.
SightQuestion question_of(const SightOptions& options);

}  // namespace lsos
