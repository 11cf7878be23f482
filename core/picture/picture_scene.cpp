#include "picture/picture_scene.h"

#include <algorithm>
#include <charconv>

#include "mission/rover/body_shape.h"
#include "mission/rover/standing_asset.h"
#include "picture/rover_colors.h"
#include "planet/ellipsoid.h"

namespace lsos {

namespace {

const Vec3 panel_front(0.03, 0.05, 0.16), panel_back(0.45, 0.45, 0.47);
constexpr double panel_half_m = 0.006;  // half thickness of a drawn panel
// Wheels that turn stay within it, so that the shadow maps of a film keep their scale.
constexpr double bound_slack_m = 0.1;

constexpr double ribbon_half_px = 0.9;
// Ribbons lie on the ground that wheels drive on; the drawn ground is a little coarser, so ribbons
// are raised and drawn nearer.
constexpr double ribbon_over_m = 0.02, ribbon_nearer = 0.004;
constexpr double ribbon_step_m = 0.4, ribbon_step_px = 6;

void add_panels(DrawnBody& body, const std::vector<PanelFace>& faces, const Vec3& eye_S_m,
                const Vec3& up_S) {
  for (const PanelFace& face : faces) {
    body.panels.push_back(face);
    const Vec3 from_body_m = face.centre_m + eye_S_m - body.p_S_m;
    const double size_m = face.half_u_m.norm() + face.half_v_m.norm();
    body.reach_m = std::max(body.reach_m, from_body_m.norm() + size_m);
    body.top_m = std::max(body.top_m, from_body_m.dot(up_S) + std::abs(face.half_u_m.dot(up_S)) +
                                          std::abs(face.half_v_m.dot(up_S)));
  }
}

void add_solids(DrawnBody& body, const std::vector<BodyShape::Solid>& solids) {
  for (const auto& solid : solids) body.solids.push_back({solid.mesh, solid.colour, false});
}

}  // namespace

std::vector<DrawnBody> drawn_bodies(const MissionModel& files, const Ground& ground,
                                    const LoggedMoment& rovers, const Vec3& eye_S_m,
                                    const Vec3& sun_S) {
  const SiteFrame& site = ground.site();
  const double g_mps2 = gravity_mps2(site.body(), site.origin());
  std::vector<DrawnBody> bodies;
  for (const LoggedRover& rover : rovers) {
    const SampleRow& sample = rover.sample;
    const auto planned = std::ranges::find(files.plan.rovers, sample.rover_id, &PlanRover::id);
    if (planned == files.plan.rovers.end()) continue;
    const RoverModel& model = files.rover_models.at(planned->model());
    const VehicleConfig vehicle = make_vehicle(model.spec, planned->configuration, g_mps2);
    const BodyShape shape(model.shapes, vehicle);
    DrawnBody body{planned->id, planned->type, sample.p_S_m, {}, {}, shape.reach_m(),
                   0,           shape.top_m()};
    const std::vector<PartPose> poses = part_poses(site, vehicle, rover);
    add_solids(body, shape.solids(poses, eye_S_m));
    const BodyShape raised(masts(model.antennas, rover));
    add_solids(body, raised.solids({poses.front()}, eye_S_m));
    std::vector<PanelFace> faces;
    for (const auto& face : panel_faces(site, model.power.panels, rover)) {
      if (!face) continue;
      faces.push_back(*face);
      faces.back().centre_m += poses.front().p_S_m - eye_S_m;
    }
    add_panels(body, faces, eye_S_m, site.up_S(sample.p_S_m));
    body.bound_m =
        std::max(std::max(body.reach_m, raised.reach_m()) + bound_slack_m, shape.reach_m(poses));
    bodies.push_back(std::move(body));
  }
  for (const PlanAsset& planned : files.plan.assets) {
    const StandingAsset asset = place_asset(planned, files.asset_models.at(planned.type), ground);
    DrawnBody body{planned.id, planned.type,       asset.pose.p_S_m, {}, {}, asset.shape.reach_m(),
                   0,          asset.shape.top_m()};
    add_solids(body, asset.shape.solids({asset.pose}, eye_S_m));
    add_panels(body, asset.panel_faces(eye_S_m, sun_S), eye_S_m, site.up_S(body.p_S_m));
    body.bound_m = body.reach_m + bound_slack_m;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

SceneBody scene_body(const DrawnBody& body, const Vec3& eye_S_m, const TerrainShadow& shadow) {
  SceneBody scene{{}, body.p_S_m - eye_S_m, body.bound_m};
  for (const PictureSolid& solid : body.solids) {
    append(scene.mesh, solid.mesh, solid.colour, &shadow);
  }
  for (const PanelFace& face : body.panels) {
    for (const double side : {1.0, -1.0}) {
      PanelFace sheet = face;
      sheet.centre_m += side * panel_half_m * face.normal();
      sheet.half_u_m *= side;  // turns its normal too
      append(scene.mesh, face_mesh(sheet), side > 0 ? panel_front : panel_back, &shadow);
    }
  }
  return scene;
}

SceneMesh track_ribbon(const Ground& ground, std::vector<TrackPoint> track, const TrackPoint& now,
                       const Camera& camera, const RibbonStyle& style) {
  std::erase_if(track, [&](const TrackPoint& point) { return point.time > now.time; });
  if (track.empty()) return {};
  track.push_back(now);
  Ground::Probe probe(ground);
  SceneMesh mesh;
  const auto add = [&](const Vec3& p_S_m, const Vec3& along_S) {
    const Vec3 up_S = ground.site().up_S(p_S_m);
    const double pixel_m = camera.metres_per_pixel((p_S_m - camera.eye_S_m).norm());
    const Vec3 aside_m =
        std::max(style.half_m, ribbon_half_px * pixel_m) * up_S.cross(along_S).normalized();
    for (const double side : {1.0, -1.0}) {
      const Vec3 edge_S_m = p_S_m + side * aside_m;
      const GroundSample sample = probe.sample(edge_S_m);
      const double lift_m = ribbon_over_m + pixel_m - (sample.is_ground() ? sample.gap_m : 0);
      const Vec3 at_m = edge_S_m + lift_m * up_S - camera.eye_S_m;
      mesh.vertices.push_back(
          {single((1 - ribbon_nearer) * at_m), single(up_S), single(style.colour), 1});
    }
  };
  for (std::size_t k = 0; k + 1 < track.size(); ++k) {
    const Vec3 from_S_m = track[k].p_S_m, delta_m = track[k + 1].p_S_m - from_S_m;
    const double pixel_m = camera.metres_per_pixel((from_S_m - camera.eye_S_m).norm());
    const double step_m = std::max(ribbon_step_m, ribbon_step_px * pixel_m);
    const int steps = std::max(1, static_cast<int>(delta_m.norm() / step_m));
    for (int i = k == 0 ? 0 : 1; i <= steps; ++i) {
      add(from_S_m + delta_m * i / steps, delta_m);
    }
  }
  for (std::uint32_t k = 0; k + 3 < mesh.vertices.size(); k += 2) {
    mesh.triangles.push_back({k, k + 1, k + 2});
    mesh.triangles.push_back({k + 1, k + 3, k + 2});
  }
  return mesh;
}

Vec3 rover_colour(std::size_t place) {
  const std::string_view text = rover_colors[place % rover_colors.size()];
  unsigned blue_green_red = 0;
  std::from_chars(text.data(), text.data() + text.size(), blue_green_red, 16);
  return Vec3(blue_green_red & 255u, blue_green_red >> 8 & 255u, blue_green_red >> 16) / 255;
}

}  // namespace lsos
