// The ground that may stand between a place and the Sun: a strip of it, from under the place to
// beyond the horizon.
#pragma once

#include "terrain/ground.h"
#include "view/gl/mesh.h"

namespace lsos {

struct SunColumn {
  Vec3 eye_S_m = Vec3::Zero();  // the middle of what is lit
  double reach_m = 1;           // all of which lies so near to it
  Vec3 sun_S = Vec3::UnitZ();   // unit, to the middle of the disc
  double disc_rad = 0;          // its angular radius
};

// Its surface about `eye_S_m` in site axes, in pieces that may hide some of the Sun from some of
// what is lit; parts that are surely too low are left out. Rows lie as close as 0.4 % of the
// distance, or 0.2 m; detail is drawn that is as wide. Beyond the ground's end it goes on at its
// last height, over the curved body. A pure function of its arguments.
Mesh ground_mesh(const Ground& ground, const SunColumn& column);

}  // namespace lsos
