// lsos.terrain, its layers, the detail on them, and lsos.soil.
#include "lua/api/terrain_constructors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lua/api/constructors.h"
#include "lua/api/raster_constructor.h"
#include "planet/body.h"

namespace lsos {

namespace {

// Greatest friction angle. No soil has a larger one, and bearing factors grow without bound towards
// a right angle.
constexpr double friction_max_rad = 1.3;

void read_plane(TableReader& t, PlaneSurface& plane) {
  t.number(optional, "height_m", plane.height_m, any_number, "At the site's origin (default 0).");
  t.number(optional, "slope_rad", plane.slope_rad, {0, 1.2}, "Inclination (default 0).");
  t.number(optional, "downslope_azimuth_rad", plane.downslope_azimuth_rad, any_number,
           "Where it falls to, clockwise from true north (default 0).");
}

void read_landform(TableReader& t, Landform& form) {
  double lon_deg = 0, lat_deg = 0;
  t.text(required, "name", form.name, "As maps have it.");
  t.number(required, "lon_deg", lon_deg, {-360, 360}, "Of its centre, east positive.");
  t.number(required, "lat_deg", lat_deg, {-90, 90}, "Of its centre.");
  t.number(required, "diameter_m", form.diameter_m, positive,
           "Rim crest to rim crest; of a mountain, its foot.");
  t.number(
      optional, "depth_m", form.depth_m, positive,
      "Of a crater, from its rim's crest to its floor; without it the landform is a mountain.");
  t.number(required, "rim_height_m", form.rim_height_m, not_negative,
           "Of the rim's crest or the mountain's top above the ground around.");
  form.lon_rad = lon_deg * std::numbers::pi / 180;
  form.lat_rad = lat_deg * std::numbers::pi / 180;
}

void read_relief(TableReader& t, ReliefSurface& relief) {
  double lon_deg = 0, lat_deg = 0;
  t.number(required, "lon_deg", lon_deg, {-360, 360}, "Of the middle of its map, east positive.");
  t.number(required, "lat_deg", lat_deg, {-90, 90}, "Of the middle of its map.");
  t.number(optional, "height_m", relief.height_m, any_number,
           "Of the ground without landforms (default 0).");
  t.number(optional, "spacing_m", relief.spacing_m, {0.5, 100}, "Of its heights (default 16).");
  t.list(required, "landforms", "landform", relief.landforms,
         "Craters and mountains; they add up.");
  relief.lon_rad = lon_deg * std::numbers::pi / 180;
  relief.lat_rad = lat_deg * std::numbers::pi / 180;
}

void read_craters(TableReader& t, CraterPopulation& craters) {
  t.number(optional, "diameter_min_m", craters.diameter_min_m, {0.1, 1e5}, "Smallest (default 3).");
  t.number(optional, "diameter_max_m", craters.diameter_max_m, positive,
           "Largest (default 60); over a raster smaller than a cell.");
  t.number(optional, "age_gyr", craters.age_gyr, {0, 4.5},
           "Age of the surface: numbers as such a lunar surface has, at most those in equilibrium. "
           "Without it they follow exponent and density_pm2.");
  t.number(optional, "exponent", craters.exponent, positive,
           "Of the cumulative size distribution (default 2).");
  t.number(optional, "density_pm2", craters.density_pm2, not_negative,
           "Craters larger than diameter_min_m per area (default 2e-4).");
  t.number(optional, "depth_to_diameter", craters.depth_to_diameter, {0, 0.4},
           "Of a fresh one (default 0.196).");
  t.number(optional, "degradation", craters.degradation, fraction,
           "0: all are fresh; 1: worn, of all ages up to the end of their lives (default 1 with "
           "an age, 0 without).");
  if (craters.diameter_min_m > craters.diameter_max_m) {
    t.fault("diameter_min_m is above diameter_max_m");
  }
  // Greatest density accepted: ten times that of a surface in equilibrium.
  const double most_pm2 = 0.8 / (craters.diameter_min_m * craters.diameter_min_m);
  if (!craters.age_gyr && craters.density_pm2 > most_pm2) {
    t.fault(fmt::format("density_pm2 = {}: at most {:.3g} craters of {} m have room",
                        craters.density_pm2, most_pm2, craters.diameter_min_m));
  }
  // With small exponents large craters dominate; so the density is also checked at the lower end of
  // the largest octave.
  const double octave_m = std::max(craters.diameter_min_m, craters.diameter_max_m / 2);
  const double larger_pm2 =
      craters.density_pm2 * std::pow(octave_m / craters.diameter_min_m, -craters.exponent);
  if (!craters.age_gyr && larger_pm2 > 0.8 / (octave_m * octave_m)) {
    t.fault(fmt::format(
        "density_pm2 = {} with exponent = {}: {:.3g} craters of {} m and more per "
        "m2; at most {:.3g} have room: a larger exponent or a smaller "
        "diameter_max_m is wanted",
        craters.density_pm2, craters.exponent, larger_pm2, octave_m, 0.8 / (octave_m * octave_m)));
  }
}

void read_rocks(TableReader& t, RockPopulation& rocks) {
  t.number(optional, "cover", rocks.cover, {0.0005, 0.5},
           "Share of the ground that rocks cover (default 0.01).");
  t.number(optional, "diameter_min_m", rocks.diameter_min_m, {0.02, 10},
           "Smallest (default 0.15).");
  t.number(optional, "diameter_max_m", rocks.diameter_max_m, {0.02, 30},
           "Largest (default 4); over a raster smaller than a cell.");
  t.number(optional, "height_to_diameter", rocks.height_to_diameter, {0.05, 1}, "Default 0.5.");
  if (rocks.diameter_min_m > rocks.diameter_max_m) {
    t.fault("diameter_min_m is above diameter_max_m");
  }
}

void read_roughness(TableReader& t, Roughness& roughness) {
  t.number(optional, "deviation_m", roughness.deviation_m, {0, 1},
           "RMS difference of height between points 1 m apart (default 0.01).");
  t.number(optional, "hurst", roughness.hurst, {0.1, 1},
           "How it grows with distance: as its power (default 0.7).");
  t.number(optional, "longest_m", roughness.longest_m, {0.1, 1000},
           "Longest wave (default 16); over a raster at most half a cell.");
}

void read_detail(TableReader& t, Detail& detail) {
  CraterPopulation craters;
  craters.diameter_min_m = -1;
  t.made(optional, "craters", "craters", craters, "Craters at random places (default none).");
  if (craters.diameter_min_m > 0) detail.craters = craters;
  RockPopulation rocks;
  rocks.cover = -1;
  t.made(optional, "rocks", "rocks", rocks, "Rocks at random places (default none).");
  if (rocks.cover > 0) detail.rocks = rocks;
  Roughness roughness;
  roughness.hurst = -1;
  t.made(optional, "roughness", "roughness", roughness,
         "Of the ground between them (default none).");
  if (roughness.hurst > 0) detail.roughness = roughness;
  t.number(optional, "spacing_m", detail.spacing_m, {0.02, 10},
           "Of the finest heights, about (default 0.25).");
}

constexpr const char* surfaces = "lsos.raster, lsos.relief or lsos.plane";

// Adds the layer at the top of the stack.
void add_layer(TableReader& t, const std::string& key, TerrainSpec& spec) {
  const ConstructedValue* made = to_constructed(t.L(), -1);
  if (made != nullptr && made->kind == "plane") {
    spec.layers.emplace_back(std::any_cast<PlaneSurface>(made->value));
  } else if (made != nullptr && made->kind == "relief") {
    spec.layers.emplace_back(std::any_cast<ReliefSurface>(made->value));
  } else if (made != nullptr && made->kind == "raster") {
    spec.layers.emplace_back(std::any_cast<RasterSurface>(made->value));
    spec.is_synthetic = false;
  } else {
    t.fault(fmt::format("{}: {} is wanted, found {}", key, surfaces, describe(t.L(), -1)));
  }
}

void read_layers(TableReader& t, TerrainSpec& spec) {
  if (!t.take(optional, "layers", "array of lsos.raster, the last lsos.relief or lsos.plane",
              "Its shape, fine to coarse; where a finer one ends, the next takes over."))
    return;
  lua_State* L = t.L();
  if (lua_istable(L, -1)) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer k = 1; k <= count; ++k) {
      lua_rawgeti(L, -1, k);
      add_layer(t, fmt::format("layers[{}]", k), spec);
      lua_pop(L, 1);
    }
    if (count == 0) t.fault("layers: at least one is wanted");
  } else if (!lua_isnil(L, -1)) {
    t.fault(fmt::format("layers: an array is wanted, found {}", describe(L, -1)));
  }
  lua_pop(L, 1);
  // A layer without an end would hide all layers below it.
  for (std::size_t k = 0; k + 1 < spec.layers.size(); ++k) {
    if (std::holds_alternative<RasterSurface>(spec.layers[k])) continue;
    t.fault(
        fmt::format("layers[{}]: only the last may be lsos.relief or lsos.plane, which have no "
                    "end",
                    k + 1));
  }
}

void read_surface(TableReader& t, TerrainSpec& spec) {
  if (t.take(optional, "surface", surfaces, "Its shape, when there is one layer.")) {
    if (!lua_isnil(t.L(), -1)) add_layer(t, "surface", spec);
    lua_pop(t.L(), 1);
  }
  const bool has_surface = !spec.layers.empty();
  TerrainSpec nested;
  read_layers(t, nested);
  if (t.L() == nullptr) return;
  if (has_surface && !nested.layers.empty()) t.fault("surface and layers: one of them is wanted");
  if (!has_surface && nested.layers.empty()) {
    t.fault("surface is missing; it or layers is wanted");
  }
  if (!has_surface) spec.layers = nested.layers;
  spec.is_synthetic = spec.is_synthetic && nested.is_synthetic;
}

std::optional<SoilChoice> read_soil_choice(TableReader& t, Need need, const char* key,
                                           const char* doc) {
  std::optional<SoilChoice> choice;
  if (!t.take(need, key, "text or lsos.soil", doc)) return choice;
  const ConstructedValue* made = to_constructed(t.L(), -1);
  if (made != nullptr && made->kind == soil_kind) {
    choice = SoilChoice{"", std::any_cast<Soil>(made->value)};
  } else if (lua_type(t.L(), -1) == LUA_TSTRING) {
    choice = SoilChoice{lua_tostring(t.L(), -1), {}};
  } else if (!lua_isnil(t.L(), -1)) {
    t.fault(fmt::format("{}: a soil's name or lsos.soil {{...}} is wanted, found {}", key,
                        describe(t.L(), -1)));
  }
  lua_pop(t.L(), 1);
  return choice;
}

void read_soil_patch(TableReader& t, SoilPatchScript& script) {
  if (auto soil =
          read_soil_choice(t, required, "soil", "A script in terrain/soils/, or the soil.")) {
    script.soil = std::move(*soil);
  }
  std::vector<double> lon_deg, lat_deg;
  t.numbers(optional, "lon_deg", lon_deg, {-360, 360}, "Of a polygon's corners, east positive.");
  t.numbers(optional, "lat_deg", lat_deg, {-90, 90}, "Of the same corners.");
  RasterSurface raster;
  t.made(optional, "raster", "raster", raster, "A raster of classes, instead of a polygon.");
  t.numbers(optional, "values", script.patch.values, any_number, "Its values that mean this soil.");
  if (t.L() == nullptr) return;
  const bool has_polygon = !lon_deg.empty() || !lat_deg.empty();
  if (has_polygon == !raster.file.empty()) {
    t.fault("a polygon (lon_deg, lat_deg) or a raster is wanted, and not both");
  }
  if (has_polygon && (lon_deg.size() != lat_deg.size() || lon_deg.size() < 3)) {
    t.fault(fmt::format("lon_deg has {} corners, lat_deg {}: as many are wanted, three at least",
                        lon_deg.size(), lat_deg.size()));
  }
  if (!raster.file.empty() && script.patch.values.empty()) {
    t.fault("values is missing; which of the raster's mean this soil?");
  }
  for (std::size_t k = 0; k < std::min(lon_deg.size(), lat_deg.size()); ++k) {
    script.patch.lon_lat_deg.emplace_back(lon_deg[k], lat_deg[k]);
  }
  if (!raster.file.empty()) script.patch.raster = raster;
}

void read_terrain_script(TableReader& t, TerrainScript& terrain) {
  t.api_version();
  t.text(required, "doc", terrain.spec.doc, "One sentence that a mission planner understands.");
  std::string& planet = terrain.spec.planet;
  t.text(optional, "planet", planet,
         "Moon, Mars or Earth, when it is a place there (default any).");
  if (!planet.empty() && find_body(planet) == nullptr) {
    t.fault(fmt::format("planet = '{}': Moon, Mars or Earth is wanted", planet));
  }
  read_surface(t, terrain.spec);
  Detail detail;
  detail.spacing_m = -1;
  t.made(optional, "detail", "detail", detail, "What is finer than the layers (default nothing).");
  if (detail.spacing_m > 0) terrain.spec.detail = detail;
  terrain.spec.place = t.place();
  if (auto soil =
          read_soil_choice(t, required, "soil", "A script in terrain/soils/, or the soil.")) {
    terrain.soil = std::move(*soil);
  }
  terrain.rock_soil =
      read_soil_choice(t, optional, "rock_soil", "Of rocks (default bare rock with friction 0.7).");
  t.number(optional, "optical_depth", terrain.spec.optical_depth, not_negative,
           "Of dust in the air, straight up (default 0.5 on Mars, else none).");
  t.number(optional, "albedo", terrain.spec.albedo, {0, 1},
           "Share of sunlight that the ground reflects onto panels that see it (default 0.25 on "
           "Mars, 0.2 on Earth, 0 on the Moon).");
  t.list(optional, "soil_patches", "soil_patch", terrain.soil_patches,
         "Ground of other soils; the first that holds a place decides.");
}

// Reads Bekker's parameters: all three or none.
void read_bekker(TableReader& t, Soil& soil) {
  std::optional<double> k_c, k_phi, n;
  t.number(optional, "k_c", k_c, any_number,
           "Bekker's cohesive modulus, N/m^(n+1). Without k_c, k_phi and n sinkage follows "
           "Terzaghi's bearing capacity.");
  t.number(optional, "k_phi", k_phi, positive, "Bekker's frictional modulus, N/m^(n+2).");
  t.number(optional, "n", n, {0.2, 2}, "Bekker's sinkage exponent.");
  if (t.L() == nullptr) return;
  if (const int given = k_c.has_value() + k_phi.has_value() + n.has_value();
      given != 0 && given != 3) {
    t.fault(
        fmt::format("{} without {}: Bekker's law needs all of k_c, k_phi and n; without any "
                    "of them Terzaghi's is used",
                    k_c     ? "k_c"
                    : k_phi ? "k_phi"
                            : "n",
                    !k_c     ? "k_c"
                    : !k_phi ? "k_phi"
                             : "n"));
  }
  soil.k_c = k_c.value_or(0);
  soil.k_phi = k_phi.value_or(0);
  soil.n = n.value_or(1);
}

}  // namespace

void read_soil(TableReader& t, Soil& soil) {
  soil.name = script_name(t.place().file);
  t.text(optional, "doc", soil.doc, "What it is and where its numbers are from.");
  t.boolean(optional, "is_rigid", soil.is_rigid,
            "Rock: wheels do not sink, friction is of wheel on rock (default false).");
  read_bekker(t, soil);
  t.number(required, "cohesion_pa", soil.cohesion_pa, not_negative, "Mohr-Coulomb cohesion.");
  t.number(required, "friction_rad", soil.friction_rad, {0, friction_max_rad},
           "Internal friction angle.");
  t.number(required, "density_kgpm3", soil.density_kgpm3, positive, "Bulk density.");
  t.number(required, "shear_modulus_x_m", soil.shear_modulus_x_m, positive,
           "Janosi and Hanamoto's K along the wheel: the displacement over which shear builds up.");
  soil.shear_modulus_y_m = soil.shear_modulus_x_m;
  t.number(optional, "shear_modulus_y_m", soil.shear_modulus_y_m, positive,
           "The same across the wheel (default: as along it).");
  t.number(optional, "slip_sinkage", soil.slip_sinkage, {0, 10},
           "How fast sinkage grows with shear under the wheel, see core/vehicle (default 2.7, the "
           "geometric mean of three measured soils).");
}

std::vector<Constructor> terrain_constructors() {
  return {constructor<TerrainScript, read_terrain_script>(terrain_kind,
                                                          "What a script in terrain/ returns."),
          constructor<PlaneSurface, read_plane>("plane", "Level or tilted ground."),
          constructor<ReliefSurface, read_relief>("relief", "Ground of landforms at known places."),
          constructor<Landform, read_landform>("landform", "A crater or a mountain."),
          constructor<Detail, read_detail>(
              "detail",
              "What is finer than the layers: by the plan's Seed, and over a raster what is "
              "smaller than its cells, so that their means stay."),
          constructor<CraterPopulation, read_craters>("craters", "Craters at random places."),
          constructor<RockPopulation, read_rocks>("rocks", "Rocks at random places."),
          constructor<Roughness, read_roughness>("roughness", "A self-affine surface."),
          constructor<SoilPatchScript, read_soil_patch>("soil_patch", "Ground of another soil."),
          constructor<RasterSurface, read_raster>("raster", "Heights from a file."),
          constructor<Soil, read_soil>(soil_kind, "What a script in terrain/soils/ returns.")};
}

}  // namespace lsos
