// A rover for planning with simple numbers: four wheels, 1000 J/m on the level, 5000 more for each
// metre of climb.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "route/route_planner.h"

namespace lsos::test {

inline constexpr double deg = std::numbers::pi / 180;

inline DriveCost simple_rover() {
  DriveCost cost;
  SoilDrive soil{-30 * deg, 5 * deg, {}, {}};
  for (int k = 0; k <= 11; ++k) {
    const double slope_rad = soil.first_rad + k * soil.step_rad;
    soil.by_slope.push_back(
        {std::max(0.0, slope_rad), std::max(0.0, 1000 + 5000 * std::sin(slope_rad)), 1});
  }
  cost.soils = {soil, soil};
  cost.wheels_B_m = {{1, 0.8}, {1, -0.8}, {-1, 0.8}, {-1, -0.8}};
  cost.underside_B_m = {{0, 0, 0.4}};
  cost.limits = {20 * deg, 0.6, 0.1, 0.3};
  return cost;
}

// Level ground at 30,10 on the Moon, with landforms at distances east and north of it.
struct Form {
  double east_m, north_m, diameter_m, depth_m, rim_height_m;
};
class Site {
 public:
  explicit Site(const std::vector<Form>& forms) : Site(std::in_place, relief(forms)) {}
  // Ground that falls to the east.
  static Site slope(double slope_rad) {
    return Site(std::in_place, PlaneSurface{0, slope_rad, std::numbers::pi / 2});
  }
  const Ground& ground() const { return ground_; }

 private:
  Site(std::in_place_t, const Surface& surface)
      : site_(body(), start()), ground_(spec(surface), site_, 1) {}
  static const Body& body() { return *find_body("Moon"); }
  static Geodetic start() { return geodetic_from_degrees(30, 10); }
  static ReliefSurface relief(const std::vector<Form>& forms) {
    ReliefSurface relief;
    relief.lon_rad = start().lon_rad;
    relief.lat_rad = start().lat_rad;
    relief.spacing_m = 1;
    for (const Form& form : forms) {
      const double radius_m = body().equatorial_radius_m;
      relief.landforms.push_back(
          {"form", start().lon_rad + form.east_m / (radius_m * std::cos(start().lat_rad)),
           start().lat_rad + form.north_m / radius_m, form.diameter_m, form.depth_m,
           form.rim_height_m});
    }
    return relief;
  }
  static TerrainSpec spec(const Surface& surface) {
    TerrainSpec spec;
    spec.name = "Site";
    spec.layers = {surface};
    return spec;
  }
  SiteFrame site_;
  Ground ground_;
};

}  // namespace lsos::test
