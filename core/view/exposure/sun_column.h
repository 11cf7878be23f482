// A mesh of the ground that may stand between a place and the Sun: a strip from below the place to
// beyond the horizon.
#pragma once

#include "terrain/ground.h"
#include "view/gl/mesh.h"

namespace lsos {

// The lit object lies within an upright cylinder about a place.
struct SunColumn {
  Vec3 eye_S_m = Vec3::Zero();    // the place
  double reach_m = 1;             // radius of the cylinder
  double low_m = -1, high_m = 1;  // its ends above the place
  Vec3 sun_S = Vec3::UnitZ();     // unit, to the centre of the disc
  double disc_rad = 0;            // its angular radius
};

// The column of an object that a sphere about the place holds.
inline SunColumn sun_column(const Vec3& eye_S_m, double radius_m, const Vec3& sun_S,
                            double disc_rad) {
  return {eye_S_m, radius_m, -radius_m, radius_m, sun_S, disc_rad};
}

// The surface relative to `eye_S_m` in site axes: the pieces that may hide part of the Sun from
// part of the lit object. Parts that are certainly too low are left out. Row spacing is 0.4 % of
// the distance, at least 0.2 m, with detail as wide as that. Beyond its end the ground continues at
// its last height over the curved body. A pure function of its arguments.
Mesh ground_mesh(const Ground& ground, const SunColumn& column);

}  // namespace lsos
