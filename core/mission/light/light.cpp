#include "mission/light/light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/exposure/sun_column.h"
#include "view/exposure/sun_disc.h"
#include "view/ground/highest_ground.h"

namespace lsos {

namespace {

// Whether the Sun is so low that none of it is seen even from a mountain over the deepest ground.
bool is_deep_night(const SiteFrame& site, const Vec3& eye_S_m, const Sunlight& light) {
  return light.seen.elevation_rad + light.disc_rad <
         -horizon_dip_rad(site.body(), site.height_m(eye_S_m));
}

// The ground that may hide the Sun from the faces, which are relative to the eye.
SunColumn column_of(const std::vector<PanelFace>& faces, const Vec3& eye_S_m, const Vec3& up_S) {
  SunColumn column{eye_S_m, 0, std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  for (const PanelFace& face : faces) {
    const double middle_m = face.centre_m.dot(up_S);
    const double half_m = std::abs(face.half_u_m.dot(up_S)) + std::abs(face.half_v_m.dot(up_S));
    column.low_m = std::min(column.low_m, middle_m - half_m);
    column.high_m = std::max(column.high_m, middle_m + half_m);
    column.reach_m = std::max(column.reach_m, (face.centre_m - middle_m * up_S).norm() +
                                                  face.half_u_m.norm() + face.half_v_m.norm());
  }
  return column;
}

}  // namespace

SunRange Light::sun_range(const LitScene& scene, const Sunlight& light) {
  const std::vector<double> none(scene.faces.size(), 0.0);
  SunRange range{none, none, none};
  if (light.irradiance_wpm2 <= 0 || light.eclipsed >= 1) return range;
  if (is_deep_night(ground_->site(), scene.eye_S_m, light)) return range;
  const Vec3 sun_S = direction_S(ground_->site(), scene.eye_S_m, light.seen);
  const double sine = std::sin(light.disc_rad);
  const auto is_facing = [&](const PanelFace& face) { return face.normal().dot(sun_S) > -sine; };
  if (std::ranges::none_of(scene.faces, is_facing)) return range;

  const std::vector<DiscSample> disc = disc_samples(sun_S, light.disc_rad, disc_samples_count);
  std::vector<Vec3> directions;
  for (const DiscSample& sample : disc) directions.push_back(sample.direction);
  Mesh all = scene.near;
  SunColumn column = column_of(scene.faces, scene.eye_S_m, ground_->site().up_S(scene.eye_S_m));
  column.sun_S = sun_S;
  column.disc_rad = light.disc_rad;
  DiscShare over_ground;  // share of the disc that is above the ground
  if (march_) {
    const double middle_m = (column.low_m + column.high_m) / 2;
    const Vec3 middle_S_m = scene.eye_S_m + middle_m * ground_->site().up_S(scene.eye_S_m);
    over_ground = share_over_ground(*ground_, *march_, middle_S_m, sun_S, light.disc_rad);
    if (over_ground.high <= 0) return range;
  } else {
    append(all, ground_mesh(*ground_, column), Mat3::Identity(), Vec3::Zero());
  }
  const std::size_t vertices = all.vertices.size(), triangles = all.triangles.size();
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    if (!is_facing(scene.faces[i])) continue;
    all.vertices.resize(vertices);
    all.triangles.resize(triangles);
    for (std::size_t k = 0; k < scene.faces.size(); ++k) {
      if (k != i) append(all, face_mesh(scene.faces[k]), Mat3::Identity(), Vec3::Zero());
    }
    const std::vector<double> shares =
        renderer_->panels.visible_shares(scene.faces[i], all, directions);
    double open = 0;  // share that the ground alone might hide
    for (std::size_t k = 0; k < disc.size(); ++k) open += disc[k].weight * shares[k];
    open *= 1 - light.eclipsed;
    range.expected[i] = open * over_ground.expected;
    range.low[i] = open * over_ground.low;
    range.high[i] = open * over_ground.high;
  }
  return range;
}

}  // namespace lsos
