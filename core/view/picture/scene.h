// What a picture shows: ground and bodies in sunlight, under a sky.
#pragma once

#include <string_view>
#include <vector>

#include "view/picture/scene_mesh.h"

namespace lsos {

// What throws one shadow: all of it lies so near to its centre.
struct SceneBody {
  SceneMesh mesh;
  Vec3 centre_m = Vec3::Zero();
  double reach_m = 1;
};

// Colours of sky and ground, red, green, blue, 0..1; as a body has them.
struct SceneAir {
  Vec3 ground, horizon, zenith;
  double sight_m = 0;    // of which the air leaves 1/e; 0: no air
  double sky_light = 0;  // share of light that comes from the sky and from ground around
  double moonlike = 0;   // share of light that ground throws back as the Moon's does, not Lambert's
};
SceneAir air_of(std::string_view body, double sun_elevation_rad);

// Lengths from the camera's eye, axes of the site.
struct Scene {
  SceneMesh ground;
  std::vector<SceneBody> bodies;
  SceneMesh marks;  // lines on the ground, in their colours as they are
  Vec3 sun_S = Vec3::UnitZ();
  Vec3 up_S = Vec3::UnitZ();
  double disc_rad = 0;  // the Sun's
  SceneAir air;
};

}  // namespace lsos
