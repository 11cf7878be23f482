// A mesh of the ground around a place, for pictures.
#pragma once

#include "terrain/ground.h"
#include "view/gl/mesh.h"

namespace lsos {

// A square of nodes x nodes vertices relative to `eye_S_m` in site axes, extending `half_m` to each
// side; triangles without ground are left out.
Mesh ground_patch(const Ground& ground, const Vec3& eye_S_m, double half_m, int nodes);

}  // namespace lsos
