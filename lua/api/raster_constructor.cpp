#include "lua/api/raster_constructor.h"

#include <fmt/format.h>

#include "base/quantity_advice.h"
#include "lua/runtime/constructed_value.h"
#include "terrain/raster/length_unit.h"

namespace lsos {

namespace {

void read_band(TableReader& t, RasterSurface& raster) {
  if (!t.take(optional, "band", "whole number or text",
              "Its band of heights: the number from 1, or the description (default 1)."))
    return;
  lua_State* L = t.L();
  raster.is_band_given = !lua_isnil(L, -1);
  if (lua_type(L, -1) == LUA_TSTRING) {
    raster.band = std::string(lua_tostring(L, -1));
  } else if (lua_isinteger(L, -1) && lua_tointeger(L, -1) >= 1 &&
             lua_tointeger(L, -1) < 1'000'000) {
    raster.band = static_cast<int>(lua_tointeger(L, -1));
  } else if (!lua_isnil(L, -1)) {
    t.fault(fmt::format(
        "band: a number from 1 or a description is wanted, found {}",
        lua_type(L, -1) == LUA_TNUMBER ? fmt::format("{}", lua_tonumber(L, -1)) : describe(L, -1)));
  }
  lua_pop(L, 1);
}

}  // namespace

void read_raster(TableReader& t, RasterSurface& raster) {
  t.text(required, "file", raster.file, "A raster that GDAL opens, relative to the script.");
  read_band(t, raster);
  t.number(optional, "nodata", raster.nodata, any_number,
           "The sample that stands for none, in place of what the file says.");
  t.text(optional, "unit", raster.unit, "Of its samples: m, km, dm, cm, mm, ft or us-ft.");
  if (!raster.unit.empty() && !length_unit_m(raster.unit)) {
    const std::vector<std::string> names = length_unit_names();
    t.fault(fmt::format("unit: '{}' is no unit of length; {} are allowed{}", raster.unit,
                        fmt::join(names, ", "), unit_advice(raster.unit, "length")));
  }
  t.boolean(optional, "is_radius", raster.is_radius,
            "Samples are distances from the body's centre, not heights (by default as their size "
            "says).");
  t.text(
      optional, "crs", raster.crs,
      "Coordinate reference system, in place of the file's: IAU_2015:30135, WKT, a PROJ string.");
}

}  // namespace lsos
