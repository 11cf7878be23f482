// What a terrain script says, as values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "terrain/spec/raster_surface.h"
#include "terrain/spec/soil.h"

namespace lsos {

// Level or tilted ground: height_m at the site's origin, rising by slope_rad towards the azimuth
// opposite to downslope_azimuth_rad (clockwise from true north there).
struct PlaneSurface {
  double height_m = 0;
  double slope_rad = 0;
  double downslope_azimuth_rad = 0;
};

// A crater or a mountain at a place that is known.
struct Landform {
  std::string name;
  double lon_rad = 0;
  double lat_rad = 0;
  double diameter_m = 0;    // diameter of the rim's crest, or of a mountain's foot
  double depth_m = 0;       // from the rim's crest to the floor; 0: a mountain
  double rim_height_m = 0;  // height of the crest, or of a mountain's top, above the ground around
};

// Ground around a place of the body, computed from the landforms on it.
struct ReliefSurface {
  double lon_rad = 0;
  double lat_rad = 0;
  double height_m = 0;  // of the ground without landforms
  double spacing_m = 16;
  std::vector<Landform> landforms;
};

using Surface = std::variant<PlaneSurface, ReliefSurface, RasterSurface>;

// Craters at random places. With an age their numbers are those that a surface of this age has, but
// no more than equilibrium allows; without, density * (D / diameter_min)^-exponent per m2 are
// larger than D.
struct CraterPopulation {
  double diameter_min_m = 3;
  double diameter_max_m = 60;
  std::optional<double> age_gyr;
  double exponent = 2;
  double density_pm2 = 2e-4;         // number per m2 of craters larger than diameter_min
  double depth_to_diameter = 0.196;  // of a fresh one
  // 0: all fresh; 1: of all ages up to the end of their lives. Absent: 1 with an age, else 0.
  std::optional<double> degradation;
};

// Rocks at random places: a share `cover` of the ground (Golombek and Rapp 1997).
struct RockPopulation {
  double cover = 0.01;
  double diameter_min_m = 0.15;
  double diameter_max_m = 4;
  double height_to_diameter = 0.5;
};

// A self-affine surface: the RMS difference of height between points L apart is
// deviation * (L / 1 m)^hurst, up to the longest wave.
struct Roughness {
  double deviation_m = 0.01;
  double hurst = 0.7;
  double longest_m = 16;
};

// What lies below the resolution of the layers.
struct Detail {
  std::optional<CraterPopulation> craters;
  std::optional<RockPopulation> rocks;
  std::optional<Roughness> roughness;
  double spacing_m = 0.25;  // approximate spacing of the finest heights
};

// Ground of another soil: within the polygon, or where the raster band holds one of the values.
struct SoilPatch {
  Soil soil;
  std::vector<std::pair<double, double>> lon_lat_deg;
  std::optional<RasterSurface> raster;
  std::vector<double> values;
};

// Layers of another terrain, which takes over where the terrain's own ones end.
struct TerrainBeyond {
  std::string name;
  std::size_t first_layer = 0;    // index among the spec's layers
  bool has_detail_alone = false;  // the spec's detail belongs to these layers only
  bool names_planet = false;      // the planet is named by it alone; the terrain itself lies on any
};

struct TerrainSpec {
  std::string name;
  std::string doc;
  std::string planet;           // body that it lies on; "": any
  Place place;                  // position of the script or of the plan's Terrain field
  std::vector<Surface> layers;  // fine to coarse
  std::optional<TerrainBeyond> beyond;
  std::optional<Detail> detail;
  Soil soil;
  std::vector<SoilPatch> soil_patches;  // the first that holds a place decides
  std::optional<Soil> rock_soil;        // soil of rocks; default: a rigid one
  std::optional<double> optical_depth;  // vertical optical depth of dust in the air
  std::optional<double> albedo;         // share of sunlight that the ground reflects
  bool is_synthetic = true;
};

}  // namespace lsos
