// The local vertical without trigonometry, for what is asked millions of times.
#pragma once

#include "planet/body.h"

namespace lsos {

struct Vertical {
  Vec3 up_F = Vec3::UnitZ();  // unit: radial on a sphere, ellipsoid normal on Earth
  double height_m = 0;        // above the reference surface
};

// On an ellipsoid exact to 1e-8 m and 1e-12 rad between -10 km and 100 km of height (Bowring 1976).
Vertical vertical(const Body& body, const Vec3& p_F_m);

// As gravity_mps2 of body.h, with the sine of the latitude in place of the latitude.
double gravity_mps2(const Body& body, double sin_lat, double height_m);

// Radii of curvature of the reference surface: `meridian_m` along the meridian, `normal_m` across.
struct Curvature {
  double meridian_m;
  double normal_m;
};
Curvature curvature(const Body& body, double sin_lat);

}  // namespace lsos
