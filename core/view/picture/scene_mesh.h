// Surfaces as a camera sees them: with colour, normals, and the share of the Sun that terrain lets
// through. Single precision: the camera's eye is their frame's origin.
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

// A solid's surface, smooth where its faces meet at less than 40 degrees. In terrain's shadow where
// `shadow` says so; nullptr: nowhere.
void append(SceneMesh& scene, const Mesh& mesh, const Vec3& colour, const TerrainShadow* shadow);

}  // namespace lsos
