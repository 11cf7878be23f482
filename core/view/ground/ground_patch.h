// The ground around a place, as pictures show it.
#pragma once

#include "terrain/ground.h"
#include "view/gl/mesh.h"

namespace lsos {

// A square of ground about `eye_S_m` in site axes, `half_m` to each side, of nodes x nodes places;
// triangles without ground are left out.
Mesh ground_patch(const Ground& ground, const Vec3& eye_S_m, double half_m, int nodes);

}  // namespace lsos
