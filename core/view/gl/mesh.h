// Surfaces as triangles, for drawing. Single precision: their frame's origin lies close by.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.h"

namespace lsos {

struct Mesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// `more` placed in the mesh's frame: p = p_m + R * vertex.
void append(Mesh& mesh, const Mesh& more, const Mat3& R, const Vec3& p_m);

// Closed boxes, and cylinders about z, centred on the origin.
Mesh box_mesh(const Vec3& size_m);
Mesh cylinder_mesh(double radius_m, double height_m, int sides = 24);

}  // namespace lsos
