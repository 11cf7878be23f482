// Rasters around a site near the Moon's south pole.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "system/temp_folder.h"

namespace lsos::test {

inline constexpr double moon_radius_m = 1737400;

// Site at 0 E, 85 S in south polar stereographic projection (Snyder 1987, eq. 21-1).
inline const double site_y_m = 2 * moon_radius_m * std::tan(2.5 * std::numbers::pi / 180);
inline constexpr const char* polar =
    R"(PROJCS["Moon south pole",GEOGCS["Moon 2000",DATUM["D_Moon_2000",SPHEROID["Moon_2000_IAU_IAG",1737400,0]],PRIMEM["Reference_Meridian",0],UNIT["degree",0.0174532925199433]],PROJECTION["Polar_Stereographic"],PARAMETER["latitude_of_origin",-90],PARAMETER["central_meridian",0],PARAMETER["scale_factor",1],PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1]])";
inline constexpr const char* mars_polar =
    R"(PROJCS["Mars south pole",GEOGCS["Mars 2000",DATUM["D_Mars_2000",SPHEROID["Mars_2000_IAU_IAG",3396190,0]],PRIMEM["Reference_Meridian",0],UNIT["degree",0.0174532925199433]],PROJECTION["Polar_Stereographic"],PARAMETER["latitude_of_origin",-90],PARAMETER["central_meridian",0],PARAMETER["scale_factor",1],PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1]])";

// A ring of hills, 50 to 450 m high, 4 km from the site.
inline double height_m(double x_m, double y_m) {
  const double away_m = std::hypot(x_m, y_m), along = (away_m - 4000) / 800;
  return (250 + 200 * std::sin(40 * std::atan2(x_m, y_m))) * std::exp(-along * along);
}

inline constexpr double missing = -9;

// Writes a square raster with cells of that size, centred `east_m` east of the site. `height_m`
// takes metres east and north of the site.
template <class Height>
std::string raster_of(const TempFolder& folder, const std::string& name, int cells, double cell_m,
                      const Height& height_m, double east_m = 0, const char* crs = polar) {
  const double half_m = cells * cell_m / 2;
  std::string text =
      fmt::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value {}\n",
                  cells, cells, east_m - half_m, site_y_m - half_m, cell_m, missing);
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const double here_m =
          height_m(east_m + (column + 0.5) * cell_m - half_m, half_m - (row + 0.5) * cell_m);
      text += fmt::format("{:.2f} ", here_m);
    }
    text += '\n';
  }
  folder.write(name + ".prj", crs);
  return folder.write(name + ".asc", text);
}

inline std::string raster(const TempFolder& folder, const std::string& name, int cells,
                          double cell_m, double east_m = 0, const char* crs = polar) {
  return raster_of(folder, name, cells, cell_m, height_m, east_m, crs);
}

}  // namespace lsos::test
