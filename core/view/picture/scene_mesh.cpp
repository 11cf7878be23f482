#include "view/picture/scene_mesh.h"

namespace lsos {

namespace {

constexpr double smooth_cosine = 0.766;  // cosine of 40 degrees

Vec3 vector(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

std::array<float, 3> single(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

void append(SceneMesh& scene, const Mesh& mesh, const Vec3& colour, const TerrainShadow* shadow) {
  std::vector<Vec3> areas;  // twice the area of each face, along its normal
  std::vector<std::vector<std::size_t>> faces_at(mesh.vertices.size());
  for (const auto& face : mesh.triangles) {
    const Vec3 a = vector(mesh.vertices[face[0]]);
    areas.push_back((vector(mesh.vertices[face[1]]) - a).cross(vector(mesh.vertices[face[2]]) - a));
    for (const std::uint32_t k : face) faces_at[k].push_back(areas.size() - 1);
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i].squaredNorm() == 0) continue;
    const Vec3 normal = areas[i].normalized();
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    for (const std::uint32_t k : mesh.triangles[i]) {
      Vec3 sum = Vec3::Zero();
      for (const std::size_t face : faces_at[k]) {
        if (areas[face].dot(normal) > smooth_cosine * areas[face].norm()) sum += areas[face];
      }
      const double share = shadow ? shadow->at(vector(mesh.vertices[k])) : 1;
      scene.vertices.push_back(
          {mesh.vertices[k], single(sum.normalized()), single(colour), static_cast<float>(share)});
    }
    scene.triangles.push_back({first, first + 1, first + 2});
  }
}

}  // namespace lsos
