#include "view/ground/ground_patch.h"

namespace lsos {

Mesh ground_patch(const Ground& ground, const Vec3& eye_S_m, double half_m, int nodes) {
  Ground::Probe probe(ground);
  Mesh mesh;
  std::vector<bool> is_ground;
  const double step_m = 2 * half_m / (nodes - 1);
  for (int j = 0; j < nodes; ++j) {
    for (int i = 0; i < nodes; ++i) {
      const Vec3 p_S_m = eye_S_m + Vec3(i * step_m - half_m, j * step_m - half_m, 0);
      const GroundSample sample = probe.sample(p_S_m);
      is_ground.push_back(sample.is_ground());
      const Vec3 at =
          is_ground.back() ? Vec3(p_S_m - sample.gap_m * sample.up_S - eye_S_m) : Vec3::Zero();
      mesh.vertices.push_back(
          {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())});
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (is_ground[a] && is_ground[b] && is_ground[c]) mesh.triangles.push_back({a, b, c});
  };
  const auto across = static_cast<std::uint32_t>(nodes);
  for (std::uint32_t j = 0; j + 1 < across; ++j) {
    for (std::uint32_t i = 0; i + 1 < across; ++i) {
      const std::uint32_t k = j * across + i;
      add(k, k + 1, k + across);
      add(k + 1, k + across + 1, k + across);
    }
  }
  return mesh;
}

}  // namespace lsos
