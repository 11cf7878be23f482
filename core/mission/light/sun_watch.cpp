#include "mission/light/sun_watch.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// When no panel faces the Sun, a square above the rover that does shows whether any sunlight falls
// on the rover.
constexpr double probe_side_m = 0.5, probe_above_m = 0.1;

// Converts from frame B to site axes, relative to the rover's reference point.
PanelFace face_of(const PanelPose& pose, const Mat3& R_SB) {
  return {R_SB * pose.p_B_m, R_SB * pose.half_u_B_m, R_SB * pose.half_v_B_m};
}

// What hides the disc is taken to hide the aureole too.
PanelSunlight::Panel lit(const PanelSpec& panel, const PanelFace& face, double sun_fraction,
                         const DiffuseView& view, const Vec3& sun_S, const Sunlight& light) {
  PanelSunlight::Panel value;
  value.sun_fraction = sun_fraction;
  value.cosine = face.normal().dot(sun_S);
  value.power_w =
      panel_power_w(panel, sun_fraction, value.cosine, light.irradiance_wpm2 + light.aureole_wpm2) +
      panel_diffuse_power_w(panel, view.sky * light.sky_wpm2 + view.ground * light.ground_wpm2);
  return value;
}

// Views of the first `count` faces; none where there is nothing to see.
std::vector<DiffuseView> diffuse_views(Light& light, const std::string& id, const LitScene& scene,
                                       std::size_t count, const Sunlight& sun) {
  if (sun.sky_wpm2 <= 0 && sun.ground_wpm2 <= 0) return std::vector<DiffuseView>(count);
  return light.diffuse_views().of(id, scene, count);
}

void append_masts(Mesh& mesh, const RoverAgent& rover, const std::vector<PartPose>& poses,
                  const Vec3& eye_S_m, SimTime now) {
  const std::vector<Shape> masts = rover.antennas().masts(now);
  if (!masts.empty()) BodyShape(masts).append_to(mesh, {poses.front()}, eye_S_m);
}

}  // namespace

void append_solids(Mesh& mesh, const RoverAgent& rover, const Vec3& eye_S_m, SimTime now) {
  const std::vector<PartPose> poses = rover.motion().part_poses();
  rover.shape().append_to(mesh, poses, eye_S_m);
  append_masts(mesh, rover, poses, eye_S_m, now);
  const PanelArray& panels = rover.power().panels();
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    if (!panels.is_up(i, now)) continue;
    PanelFace face = face_of(panels.pose_at(i, now), poses[0].R_SB);
    face.centre_m += poses[0].p_S_m - eye_S_m;
    append(mesh, face_mesh(face), Mat3::Identity(), Vec3::Zero());
  }
}

void append_solids(Mesh& mesh, const StandingAsset& asset, const Vec3& eye_S_m, const Vec3& sun_S) {
  asset.shape.append_to(mesh, {asset.pose}, eye_S_m);
  for (const PanelFace& face : asset.panel_faces(eye_S_m, sun_S)) {
    append(mesh, face_mesh(face), Mat3::Identity(), Vec3::Zero());
  }
}

void aim_panels(const Ground& ground, RoverAgent& rover, const Sunlight& sun, SimTime now) {
  const SiteFrame& site = ground.site();
  const Vec3& p_S_m = rover.view().p_S_m;
  const Mat3 R_BS = rover.motion().part_poses()[0].R_SB.transpose();
  rover.power().panels().aim(
      {R_BS * direction_S(site, p_S_m, sun.seen), sun.seen.elevation_rad + sun.disc_rad > 0,
       R_BS * site.north_S(p_S_m), R_BS * site.up_S(p_S_m)},
      now);
}

PanelSunlight evaluate_sunlight(Light& light, const Ground& ground, const RoverAgent& rover,
                                const Mesh& others, const Sunlight& sun, SimTime now) {
  const SiteFrame& site = ground.site();
  const Vec3& p_S_m = rover.view().p_S_m;
  const Vec3 sun_S = direction_S(site, p_S_m, sun.seen);
  const std::vector<PartPose> poses = rover.motion().part_poses();
  const Mat3& R_SB = poses[0].R_SB;
  const PanelArray& panels = rover.power().panels();

  LitScene scene{p_S_m, {}, others};
  rover.shape().append_to(scene.near, poses, p_S_m);
  append_masts(scene.near, rover, poses, p_S_m, now);
  std::vector<std::size_t> up;
  bool is_any_facing = false;
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    if (!panels.is_up(i, now)) continue;
    up.push_back(i);
    scene.faces.push_back(face_of(panels.pose_at(i, now), R_SB));
    is_any_facing |= scene.faces.back().normal().dot(sun_S) > 0;
  }
  if (!is_any_facing) {
    const Vec3 u = sun_S.unitOrthogonal() * (probe_side_m / 2);
    scene.faces.push_back(
        {R_SB * Vec3(0, 0, rover.shape().top_m() + probe_above_m), u, sun_S.cross(u)});
  }
  const SunRange range = light.sun_range(scene, sun);
  const std::vector<double>& fractions = range.expected;
  const std::vector<DiffuseView> views = diffuse_views(light, rover.id(), scene, up.size(), sun);

  PanelSunlight value;
  value.time = now;
  value.panels.resize(panels.specs().size());
  for (std::size_t k = 0; k < up.size(); ++k) {
    const auto lit_by = [&](double fraction) {
      return lit(panels.specs()[up[k]], scene.faces[k], fraction, views[k], sun_S, sun);
    };
    const PanelSunlight::Panel& panel = value.panels[up[k]] = lit_by(fractions[k]);
    value.less_w += panel.power_w - lit_by(range.low[k]).power_w;
    value.more_w += lit_by(range.high[k]).power_w - panel.power_w;
  }
  const auto is_none = [](double fraction) { return fraction <= 0; };
  value.is_dark = std::ranges::all_of(fractions, is_none);
  value.may_be_dark = std::ranges::all_of(range.low, is_none);
  value.may_be_lit = !std::ranges::all_of(range.high, is_none);
  return value;
}

PanelSunlight evaluate_sunlight(Light& light, const Ground& ground, const StandingAsset& asset,
                                const Mesh& others, const Sunlight& sun, SimTime now) {
  const SiteFrame& site = ground.site();
  const Vec3& p_S_m = asset.pose.p_S_m;
  const Vec3 sun_S = direction_S(site, p_S_m, sun.seen);
  LitScene scene{p_S_m, asset.panel_faces(p_S_m, sun_S), others};
  asset.shape.append_to(scene.near, {asset.pose}, p_S_m);
  const std::vector<double> fractions = light.sun_fractions(scene, sun);
  const std::vector<DiffuseView> views =
      diffuse_views(light, asset.plan.id, scene, scene.faces.size(), sun);
  PanelSunlight value{now, false, {}};
  for (std::size_t k = 0; k < scene.faces.size(); ++k) {
    value.panels.push_back(
        lit(asset.model.panels[k], scene.faces[k], fractions[k], views[k], sun_S, sun));
  }
  return value;
}

}  // namespace lsos
