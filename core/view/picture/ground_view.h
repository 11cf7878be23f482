// The ground that a camera sees, to beyond the horizon, about as fine as the picture's pixels.
#pragma once

#include "view/picture/camera.h"
#include "view/picture/scene_mesh.h"

namespace lsos {

// All of it that the camera may see.
GroundSector sector_of(const SiteFrame& site, const Camera& camera);

// From the camera's eye. Beyond the ground's end it goes on at its last height over the curved
// body. A pure function of its arguments.
SceneMesh ground_view(const Ground& ground, const Camera& camera, const TerrainShadow& shadow,
                      const Vec3& colour);

// The lowest place of an eye over a place from which the ground does not hide a target, and at
// least `clear_m` above the ground.
Vec3 clear_eye_S_m(const Ground& ground, const Vec3& eye_S_m, const Vec3& target_S_m,
                   double clear_m);

}  // namespace lsos
