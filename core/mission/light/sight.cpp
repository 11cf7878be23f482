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

constexpr const char* ground_name = "ground";

Mesh merged(const std::vector<NamedMesh>& solids) {
  Mesh all;
  for (const NamedMesh& solid : solids) append(all, solid.mesh, Mat3::Identity(), Vec3::Zero());
  return all;
}

// What hides a target, see Sight::Disc. `is_seen_past(mesh)`: whether it is seen where only that
// stands in between.
template <class IsSeenPast>
std::string hidden_by(const std::vector<NamedMesh>& solids, const Mesh& ground,
                      const IsSeenPast& is_seen_past) {
  if (solids.empty() || !is_seen_past(ground)) return ground_name;
  std::string all, alone;
  for (const NamedMesh& solid : solids) {
    const auto add_to = [&](std::string& ids) { ids += (ids.empty() ? "" : ",") + solid.id; };
    add_to(all);
    if (!is_seen_past(solid.mesh)) add_to(alone);
  }
  return alone.empty() ? all : alone;
}

}  // namespace

double Sight::share(const PanelFace& target, const Mesh& solids, const Viewpoint& viewer) {
  return renderer_->panels.visible_shares(target, solids, std::span(&viewer, 1),
                                          antenna_margins)[0];
}

Sight::Line Sight::line(const Vec3& from_S_m, const Vec3& to_S_m,
                        const std::vector<NamedMesh>& solids) {
  const Vec3 line_m = to_S_m - from_S_m;
  const double distance_m = line_m.norm();
  if (distance_m <= antenna_margins.panel_m + antenna_margins.viewer_m) return {1, true, ""};
  if (passes_under_ground(site_, from_S_m, to_S_m)) return {0, false, ground_name};
  const Mesh ground = between_.between(from_S_m, to_S_m, target_half_m);
  const Viewpoint viewer{-line_m / distance_m, distance_m};
  const PanelFace face = target(line_m, viewer.direction);
  Mesh all = merged(solids);
  append(all, ground, Mat3::Identity(), Vec3::Zero());
  Line seen{share(face, all, viewer), false, ""};
  seen.is_seen = seen.share >= seen_share;
  if (seen.is_seen) return seen;
  seen.hidden_by = hidden_by(
      solids, ground, [&](const Mesh& mesh) { return share(face, mesh, viewer) >= seen_share; });
  return seen;
}

Sight::Disc Sight::disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad,
                        const std::vector<NamedMesh>& solids) {
  const double elevation_rad = std::asin(direction_S.dot(site_.up_S(from_S_m)));
  if (elevation_rad + disc_rad < -horizon_dip_rad(site_.body(), site_.height_m(from_S_m)))
    return {false, 0, ground_name};
  const Mesh ground =
      ground_mesh(*ground_, sun_column(from_S_m, target_half_m, direction_S, disc_rad));
  Mesh all = merged(solids);
  append(all, ground, Mat3::Identity(), Vec3::Zero());
  std::vector<Viewpoint> viewers{{direction_S}};
  const std::vector<DiscSample> places = disc_samples(direction_S, disc_rad, disc_samples_count);
  for (const DiscSample& place : places) viewers.push_back({place.direction});
  const PanelFace face = target(Vec3::Zero(), direction_S);
  const std::vector<double> shares =
      renderer_->panels.visible_shares(face, all, viewers, antenna_margins);
  Disc seen{shares[0] >= centre_share, 0, ""};
  for (std::size_t k = 0; k < places.size(); ++k) seen.fraction += places[k].weight * shares[k + 1];
  if (seen.is_centre_seen) return seen;
  seen.hidden_by = hidden_by(solids, ground, [&](const Mesh& mesh) {
    return share(face, mesh, viewers.front()) >= centre_share;
  });
  return seen;
}

Sight::Disc Sight::marched_disc(const Vec3& from_S_m, const Vec3& direction_S, double disc_rad,
                                const std::vector<NamedMesh>& solids) {
  const double fraction =
      share_over_ground(*ground_, march_, from_S_m, direction_S, disc_rad).expected;
  if (fraction < centre_share) return {false, fraction, ground_name};
  if (solids.empty()) return {true, fraction, ""};
  const Viewpoint viewer{direction_S};
  const PanelFace face = target(Vec3::Zero(), direction_S);
  if (share(face, merged(solids), viewer) >= centre_share) return {true, fraction, ""};
  return {false, 0, hidden_by(solids, {}, [&](const Mesh& mesh) {
            return share(face, mesh, viewer) >= centre_share;
          })};
}

}  // namespace lsos
