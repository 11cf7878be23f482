// Surfaces for a camera's picture, with colour, normals, and the share of the Sun that terrain lets
// through. Single precision suffices because the camera's eye is the origin.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "view/gl/mesh.h"
#include "view/ground/terrain_shadow.h"

namespace lsos {

struct SceneVertex {
  std::array<float, 3> p_m{};
  std::array<float, 3> normal{};
  std::array<float, 3> colour{};
  float sun_share = 1;
};

struct SceneMesh {
  std::vector<SceneVertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

std::array<float, 3> single(const Vec3& v);

// Adds a solid's surface, shaded smoothly where its faces meet at less than 40 degrees. `shadow`:
// the terrain's shadow on it; nullptr: none.
void append(SceneMesh& scene, const Mesh& mesh, const Vec3& colour, const TerrainShadow* shadow);

}  // namespace lsos
