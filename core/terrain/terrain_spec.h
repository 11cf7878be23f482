// What a terrain script says, as values.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "base/error.h"
#include "terrain/soil.h"

namespace lsos {

// A raster that GDAL opens.
struct RasterSurface {
  std::string file;
  int band = 1;
};

// Level or tilted ground: height_m at the site's origin, rising by slope_rad towards the azimuth
// opposite to downslope_azimuth_rad (clockwise from true north there).
struct PlaneSurface {
  double height_m = 0;
  double slope_rad = 0;
  double downslope_azimuth_rad = 0;
};

// A plane with seeded bowl craters: cumulative number per m2 larger than D is
// density * (D/diameter_min)^-exponent between the two diameters.
struct CraterSurface {
  PlaneSurface base;
  double diameter_min_m = 3;
  double diameter_max_m = 60;
  double exponent = 2;
  double density_pm2 = 2e-4;  // craters larger than diameter_min a m2
  double depth_to_diameter = 0.15;
};

struct TerrainSpec {
  std::string name;
  Place place;  // of the script or the plan's Terrain field
  std::variant<PlaneSurface, CraterSurface, RasterSurface> surface;
  Soil soil;
  bool is_synthetic = true;
};

}  // namespace lsos
