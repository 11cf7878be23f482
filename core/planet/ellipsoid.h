// Formulas of the reference ellipsoid that need no latitude, only its sine.
#pragma once

#include "planet/body.h"

namespace lsos {

// As gravity_mps2 of body.h, with the sine of the latitude in place of the latitude.
double gravity_mps2(const Body& body, double sin_lat, double height_m);

// Gauss's radius of curvature, the geometric mean of the radii along and across the meridian, which
// differ from it by at most 0.34 % on Earth.
double curvature_radius_m(const Body& body, double sin_lat);

}  // namespace lsos
