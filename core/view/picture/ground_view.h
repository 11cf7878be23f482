// A mesh of the ground that a camera sees, to beyond the horizon, at about the resolution of the
// picture's pixels.
#pragma once

#include "view/picture/camera.h"
#include "view/picture/scene_mesh.h"

namespace lsos {

// The sector that holds all ground that the camera may see.
GroundSector sector_of(const SiteFrame& site, const Camera& camera);

// The mesh is relative to the camera's eye. Where the terrain's data end it goes on at the last
// height over the curved body. A pure function of its arguments.
SceneMesh ground_view(const Ground& ground, const Camera& camera, const TerrainShadow& shadow,
                      const Vec3& colour);

// The eye, raised vertically until the line of sight clears the ground by a margin that grows from
// 0 at the target to `clear_m` at the eye.
Vec3 clear_eye_S_m(const Ground& ground, const Vec3& eye_S_m, const Vec3& target_S_m,
                   double clear_m);

}  // namespace lsos
