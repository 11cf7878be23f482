#include "mission/light/sight.h"

#include <cmath>

#include "view/exposure/sun_column.h"
#include "view/exposure/sun_disc.h"
#include "view/ground/highest_ground.h"

namespace lsos {

namespace {

constexpr ViewMargins antenna_margins{0.3, 0.3};
constexpr double centre_share = 0.5;  // share of the target that the centre of the disc sees

// The target, facing `towards`, relative to the viewer.
PanelFace target(const Vec3& centre_m, const Vec3& towards) {
  const Vec3 u = towards.unitOrthogonal() * Sight::target_half_m;
  return {centre_m, u, towards.cross(u)};
}

}  // namespace

double Sight::target_share(const Vec3& from_S_m, const Vec3& to_S_m, const Mesh& solids) {
  const Vec3 line_m = to_S_m - from_S_m;
  const double distance_m = line_m.norm();
  if (distance_m <= antenna_margins.panel_m + antenna_margins.viewer_m) return 1;
  if (passes_under_ground(site_, from_S_m, to_S_m)) return 0;
  Mesh all = solids;
  append(all, between_.between(from_S_m, to_S_m, target_half_m), Mat3::Identity(), Vec3::Zero());
  const Viewpoint viewer{-line_m / distance_m, distance_m};
  return renderer_->panels.visible_shares(target(line_m, viewer.direction), all,
                                          std::span(&viewer, 1), antenna_margins)[0];
}

Sight::Disc Sight::disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad,
                        const Mesh& solids) {
  const double elevation_rad = std::asin(direction_S.dot(site_.up_S(from_S_m)));
  if (elevation_rad + disc_rad < -horizon_dip_rad(site_.body(), site_.height_m(from_S_m)))
    return {};
  Mesh all = solids;
  append(all, ground_mesh(*ground_, sun_column(from_S_m, target_half_m, direction_S, disc_rad)),
         Mat3::Identity(), Vec3::Zero());
  std::vector<Viewpoint> viewers{{direction_S}};
  const std::vector<DiscSample> places = disc_samples(direction_S, disc_rad, disc_samples_count);
  for (const DiscSample& place : places) viewers.push_back({place.direction});
  const std::vector<double> shares = renderer_->panels.visible_shares(
      target(Vec3::Zero(), direction_S), all, viewers, antenna_margins);
  Disc seen{shares[0] >= centre_share, 0};
  for (std::size_t k = 0; k < places.size(); ++k) seen.fraction += places[k].weight * shares[k + 1];
  return seen;
}

}  // namespace lsos
