// A camera's picture: ground and solids in sunlight, with cast shadows, under a sky.
#pragma once

#include <string_view>
#include <vector>

#include "view/picture/scene_mesh.h"

namespace lsos {

// A body that casts one shadow; it lies within `reach_m` of its centre.
struct SceneBody {
  SceneMesh mesh;
  Vec3 centre_m = Vec3::Zero();
  double reach_m = 1;
};

// Colours of a body's sky and ground: red, green, blue, 0..1.
struct SceneAir {
  Vec3 ground, horizon, zenith;
  double sight_m = 0;    // distance over which the air leaves 1/e of the light; 0: no air
  double sky_light = 0;  // share of light that comes from the sky and the surrounding ground
  double moonlike = 0;   // share of light that ground reflects as on the Moon; rest: Lambertian
};
SceneAir air_of(std::string_view body, double sun_elevation_rad);

// Positions are relative to the camera's eye, in site axes.
struct Scene {
  SceneMesh ground;
  std::vector<SceneBody> bodies;
  SceneMesh marks;  // lines on the ground, in unshaded colours
  Vec3 sun_S = Vec3::UnitZ();
  Vec3 up_S = Vec3::UnitZ();
  double disc_rad = 0;  // angular radius of the Sun
  SceneAir air;
};

}  // namespace lsos
