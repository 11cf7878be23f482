// Gravity and curvature of the reference ellipsoid.
#pragma once

#include "planet/body.h"

namespace lsos {

// Magnitude of gravity at that place, m/s2: GM/r^2 on Moon and Mars; WGS84 normal gravity with
// the free-air correction on Earth (Moritz 1980, Geodetic Reference System).
double gravity_mps2(const Body& body, const Geodetic& place);

// The same with the sine of the latitude in place of the latitude.
double gravity_mps2(const Body& body, double sin_lat, double height_m);

// Gauss's radius of curvature, the geometric mean of the radii along and across the meridian, which
// differ from it by at most 0.34 % on Earth.
double curvature_radius_m(const Body& body, double sin_lat);

}  // namespace lsos
