// lsos.terrain, its surfaces lsos.plane, lsos.craters, lsos.raster, and lsos.soil.
#include "lua/terrain_constructors.h"

#include <fmt/format.h>

#include <numbers>

#include "lua/constructors.h"

namespace lsos {

namespace {

using Surface = decltype(TerrainSpec::surface);

// Steeper than any soil; bearing factors grow without bound towards a right angle.
constexpr double friction_max_rad = 1.3;

void read_plane(TableReader& t, PlaneSurface& plane) {
  t.number(optional, "height_m", plane.height_m, any_number, "At the site's origin (default 0).");
  t.number(optional, "slope_rad", plane.slope_rad, {0, 1.2}, "Inclination (default 0).");
  t.number(optional, "downslope_azimuth_rad", plane.downslope_azimuth_rad, any_number,
           "Where it falls to, clockwise from true north (default 0).");
}

void read_craters(TableReader& t, CraterSurface& craters) {
  t.made(optional, "base", "plane", craters.base, "The ground between craters (default level).");
  t.number(optional, "diameter_min_m", craters.diameter_min_m, positive, "Smallest (default 3).");
  t.number(optional, "diameter_max_m", craters.diameter_max_m, positive, "Largest (default 60).");
  t.number(optional, "exponent", craters.exponent, positive,
           "Of the cumulative size distribution (default 2).");
  t.number(optional, "density_pm2", craters.density_pm2, not_negative,
           "Craters larger than diameter_min_m per area (default 2e-4).");
  t.number(optional, "depth_to_diameter", craters.depth_to_diameter, {0, 0.4},
           "Fresh bowl craters have 0.15 to 0.2 (default 0.15).");
  if (craters.diameter_min_m > craters.diameter_max_m) {
    t.fault("diameter_min_m is above diameter_max_m");
  }
}

void read_raster(TableReader& t, RasterSurface& raster) {
  std::int64_t band = raster.band;
  t.text(required, "file", raster.file, "A raster that GDAL opens, relative to the script.");
  t.integer(optional, "band", band, {1, 1e6}, "Its band of heights (default 1).");
  raster.band = static_cast<int>(band);
}

void read_surface(TableReader& t, TerrainSpec& spec) {
  if (!t.take(required, "surface", "lsos.plane, lsos.craters or lsos.raster", "Its shape.")) return;
  const Made* made = to_made(t.L(), -1);
  if (made != nullptr && made->kind == "plane") {
    spec.surface = std::any_cast<PlaneSurface>(made->value);
  } else if (made != nullptr && made->kind == "craters") {
    spec.surface = std::any_cast<CraterSurface>(made->value);
  } else if (made != nullptr && made->kind == "raster") {
    spec.surface = std::any_cast<RasterSurface>(made->value);
    spec.is_synthetic = false;
  } else if (!lua_isnil(t.L(), -1)) {
    t.fault(fmt::format("surface: lsos.plane, lsos.craters or lsos.raster is wanted, found {}",
                        describe(t.L(), -1)));
  }
  lua_pop(t.L(), 1);
}

void read_terrain(TableReader& t, TerrainScript& terrain) {
  t.api_version();
  t.text(required, "doc", terrain.doc, "One sentence that a mission planner understands.");
  read_surface(t, terrain.spec);
  terrain.spec.place = t.place();
  if (!t.take(required, "soil", "text or lsos.soil", "A script in terrain/soils/, or the soil."))
    return;
  const Made* made = to_made(t.L(), -1);
  if (made != nullptr && made->kind == soil_kind) {
    terrain.spec.soil = std::any_cast<Soil>(made->value);
  } else if (lua_type(t.L(), -1) == LUA_TSTRING) {
    terrain.soil_name = lua_tostring(t.L(), -1);
  } else if (!lua_isnil(t.L(), -1)) {
    t.fault(fmt::format("soil: a soil's name or lsos.soil {{...}} is wanted, found {}",
                        describe(t.L(), -1)));
  }
  lua_pop(t.L(), 1);
}

// Bekker's parameters: all three or none.
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
  std::string doc;
  soil.name = script_name(t.place().file);
  t.text(optional, "doc", doc, "What it is and where its numbers are from.");
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
           "How fast sinkage grows with shear under the wheel, see core/vehicle (default 1).");
}

std::vector<Constructor> terrain_constructors() {
  return {
      constructor<TerrainScript, read_terrain>(terrain_kind, "What a script in terrain/ returns."),
      constructor<PlaneSurface, read_plane>("plane", "Level or tilted ground."),
      constructor<CraterSurface, read_craters>("craters",
                                               "A plane with bowl craters by the plan's Seed."),
      constructor<RasterSurface, read_raster>("raster", "Heights from a file."),
      constructor<Soil, read_soil>(soil_kind, "What a script in terrain/soils/ returns.")};
}

}  // namespace lsos
