#include "mission/light/diffuse_view_cache.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr double cell_m = 4, cell_height_m = 0.5;

bool is_same(const PanelFace& a, const PanelFace& b) {
  return a.centre_m == b.centre_m && a.half_u_m == b.half_u_m && a.half_v_m == b.half_v_m;
}

bool is_same(const Mesh& a, const Mesh& b) {
  return a.vertices == b.vertices && a.triangles == b.triangles;
}

}  // namespace

DiffuseViewCache::Cell DiffuseViewCache::cell_of(const Vec3& eye_S_m,
                                                 const std::vector<PanelFace>& faces,
                                                 const Vec3& up_S) {
  double highest_m = 0;
  for (const PanelFace& face : faces) highest_m = std::max(highest_m, face.centre_m.dot(up_S));
  const auto nearest = [](double value_m, double step_m) {
    return static_cast<int>(std::lround(value_m / step_m));
  };
  return {nearest(eye_S_m.x(), cell_m), nearest(eye_S_m.y(), cell_m),
          nearest(highest_m, cell_height_m)};
}

// Depends on the cell alone, so that a run that is resumed finds the same horizon. Where the middle
// of the cell has no ground, it is taken to be level.
TerrainHorizon DiffuseViewCache::horizon(const Cell& cell) const {
  const Vec3 p_S_m(cell.x * cell_m, cell.y * cell_m, 0);
  const GroundSample below = Ground::Probe(*ground_).sample(p_S_m);
  if (!below.is_ground()) return {};
  return terrain_horizon(*ground_,
                         p_S_m + (cell.height * cell_height_m - below.gap_m) * below.up_S);
}

std::vector<OpenShares> DiffuseViewCache::drawn(const LitScene& scene, std::size_t count) {
  std::vector<OpenShares> open;
  Mesh all = scene.near;
  const std::size_t vertices = all.vertices.size(), triangles = all.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    all.vertices.resize(vertices);
    all.triangles.resize(triangles);
    for (std::size_t k = 0; k < count; ++k) {
      if (k != i) append(all, face_mesh(scene.faces[k]), Mat3::Identity(), Vec3::Zero());
    }
    open.push_back(open_shares(renderer_->panels, scene.faces[i], all));
  }
  return open;
}

std::vector<DiffuseView> DiffuseViewCache::of(const std::string& id, const LitScene& scene,
                                              std::size_t count) {
  const SiteFrame& site = ground_->site();
  const Compass compass{site.north_S(scene.eye_S_m), site.east_S(scene.eye_S_m),
                        site.up_S(scene.eye_S_m)};
  Kept& kept = kept_[id];
  const std::vector<PanelFace> faces(scene.faces.begin(),
                                     scene.faces.begin() + static_cast<std::ptrdiff_t>(count));
  const auto is_same_face = [](const PanelFace& a, const PanelFace& b) { return is_same(a, b); };
  if (!std::ranges::equal(kept.faces, faces, is_same_face) || !is_same(kept.near, scene.near)) {
    kept.open = drawn(scene, count);
    kept.faces = faces;
    kept.near = scene.near;
  }
  const Cell cell = cell_of(scene.eye_S_m, faces, compass.up);
  if (kept.cell != cell) {
    kept.horizon = horizon(cell);
    kept.cell = cell;
  }
  std::vector<DiffuseView> views;
  for (std::size_t i = 0; i < count; ++i) {
    views.push_back(diffuse_view(kept.open[i], faces[i], kept.horizon, compass));
  }
  return views;
}

}  // namespace lsos
