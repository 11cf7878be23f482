#include "view/gl/mesh.h"

#include <cmath>
#include <numbers>

namespace lsos {

namespace {

std::array<float, 3> vertex_floats(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

void append(Mesh& mesh, const Mesh& more, const Mat3& R, const Vec3& p_m) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& v : more.vertices) {
    mesh.vertices.push_back(vertex_floats(p_m + R * Vec3(v[0], v[1], v[2])));
  }
  for (const auto& t : more.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

Mesh box_mesh(const Vec3& size_m) {
  Mesh mesh;
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(vertex_floats(corner.cwiseProduct(size_m)));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Mesh cylinder_mesh(double radius_m, double height_m, int sides) {
  Mesh mesh;
  const auto n = static_cast<std::uint32_t>(sides);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    const double x = radius_m * std::cos(angle), y = radius_m * std::sin(angle);
    mesh.vertices.push_back(vertex_floats({x, y, -height_m / 2}));
    mesh.vertices.push_back(vertex_floats({x, y, height_m / 2}));
  }
  mesh.vertices.push_back(vertex_floats({0, 0, -height_m / 2}));
  mesh.vertices.push_back(vertex_floats({0, 0, height_m / 2}));
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t low = 2 * k, next = 2 * ((k + 1) % n);
    mesh.triangles.push_back({low, next, low + 1});
    mesh.triangles.push_back({next, next + 1, low + 1});
    mesh.triangles.push_back({2 * n, next, low});
    mesh.triangles.push_back({2 * n + 1, low + 1, next + 1});
  }
  return mesh;
}

}  // namespace lsos
