// Where Curiosity stood on sols 960 to 1073, and the 1 m HiRISE elevation model of Gale crater that
// these places lie on, read and projected by other means than the program.
#pragma once

#include <gdal_priv.h>

#include <array>
#include <filesystem>
#include <numbers>
#include <vector>

namespace lsos::test {

inline constexpr double mars_radius_m = 3396190;  // sphere of the raster, IAU 2000

inline constexpr const char* gale_traverse = "traverses/MSL_Waypoints_sol3_1782.csv";
inline constexpr const char* gale_raster = "dem/mars/gale_hirise_1m_missionDEM.tif";

// One localisation. Yaw is the heading, clockwise from north: the rover's x axis is forward and its
// z axis down. Longitude and latitude are planetocentric; easting and northing are these angles
// times the sphere's radius.
struct Localisation {
  int sol = 0;
  double easting_m = 0, northing_m = 0, elevation_m = 0, yaw_rad = 0;
  double lon_deg() const { return easting_m / mars_radius_m * 180 / std::numbers::pi; }
  double lat_deg() const { return northing_m / mars_radius_m * 180 / std::numbers::pi; }
};

struct TraverseRow : Localisation {
  double lon_as_written_deg = 0, lat_as_written_deg = 0;
  double driven_m = 0;  // since the localisation before, by its wheels
};

std::vector<TraverseRow> curiosity_traverse();

class GaleRaster {
 public:
  explicit GaleRaster(const std::filesystem::path& file);

  // Whether the raster holds a place, with room for a rover and the cells around it.
  bool holds(const Localisation& stand) const;
  // Height interpolated by Catmull and Rom's cubic through the 4 x 4 nearest cell centres.
  double height_m(double easting_m, double northing_m) const;

 private:
  double column(double easting_m) const;
  double row(double northing_m) const;

  GDALDatasetUniquePtr dataset_;
  double transform_[6] = {};
};

}  // namespace lsos::test
