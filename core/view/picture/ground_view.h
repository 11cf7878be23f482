// A mesh of the ground that a camera sees, to beyond the horizon, at about the resolution of the
// picture's pixels.
#pragma once

#include "view/picture/camera.h"
#include "view/picture/scene_mesh.h"

namespace lsos {

// The sector that holds all ground that the camera may see.
GroundSector sector_of(const SiteFrame& site, const Camera& camera);

// The mesh is relative to the camera's eye. Beyond its end the ground continues at its last height
// over the curved body. A pure function of its arguments.
SceneMesh ground_view(const Ground& ground, const Camera& camera, const TerrainShadow& shadow,
                      const Vec3& colour);

// Raises the eye vertically as little as needed for the ground not to hide the target and for the
// eye to be at least `clear_m` above the ground.
Vec3 clear_eye_S_m(const Ground& ground, const Vec3& eye_S_m, const Vec3& target_S_m,
                   double clear_m);

}  // namespace lsos
