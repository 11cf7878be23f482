// `lsos-host picture`: a rover of a run as the Sun saw it, its panels in green.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "lua/commands.h"
#include "lua/mission_files.h"
#include "mission/body_shape.h"
#include "mission/logged_rover.h"
#include "mission/site.h"
#include "mission/standing_asset.h"
#include "product/files.h"
#include "product/png.h"
#include "record/log.h"
#include "view/ground_patch.h"
#include "view/sun_column.h"
#include "view/sun_picture.h"

namespace lsos {

namespace {

const Vec3 green(0, 1, 0), panel_back(0.15, 0.18, 0.35), ground_grey(0.42, 0.42, 0.42);

// So much of the surroundings is drawn, in reaches of the rover.
constexpr double frame_reaches = 0.9, neighbours_reaches = 12;

SimTime time_of(const std::string& text, Instant start) {
  if (const Parsed<double> time_s = parse_quantity(text, *find_unit("s")))
    return from_seconds(*time_s.value);
  if (const Parsed<Instant> at = parse_utc(text)) return *at.value - start;
  throw InputError({}, fmt::format("--at {}: UTC or a time from the start is wanted, as "
                                   "2026-07-01T00:10:00Z or 10 min",
                                   text));
}

// Each rover at its last sample until then.
std::vector<LoggedRover> rovers_at(const LogReader& log, SimTime time) {
  std::map<std::string, LoggedRover> rovers;
  log.for_each_sample([&](const SampleRow& row) {
    if (row.time <= time) rovers[row.rover_id].sample = row;
  });
  const auto is_of = [](const auto& row, const LoggedRover& rover) {
    return row.rover_id == rover.sample.rover_id && row.time == rover.sample.time;
  };
  for (const JointRow& row : log.joints()) {
    const auto rover = rovers.find(row.rover_id);
    if (rover != rovers.end() && is_of(row, rover->second)) rover->second.joints.push_back(row);
  }
  for (const PanelRow& row : log.panels()) {
    const auto rover = rovers.find(row.rover_id);
    if (rover != rovers.end() && is_of(row, rover->second)) rover->second.panels.push_back(row);
  }
  std::vector<LoggedRover> found;
  for (auto& [id, rover] : rovers) found.push_back(std::move(rover));
  return found;
}

// Scripts and rasters may lie beside the plan that was run; the seed may have been an option.
MissionFiles mission_of(const std::string& folder, const std::map<std::string, std::string>& run) {
  std::string plan_file = folder + "/plan.kml";
  const auto summary =
      nlohmann::json::parse(read_file(folder + "/summary.json").value_or("{}"), nullptr, false);
  if (summary.is_object() && summary.contains("plan")) {
    const std::string original = summary["plan"].get<std::string>();
    if (std::filesystem::is_regular_file(original)) plan_file = original;
  }
  const std::uint64_t seed = std::stoull(run.at("seed"));
  MissionFiles files = read_mission(plan_file, seed);
  if (!files.faults.has_errors() && files.plan.hash() == run.at("plan_sha256")) return files;
  files = read_mission(folder + "/plan.kml", seed);
  files.faults.throw_if_errors();
  return files;
}

const LoggedRover& chosen(const std::vector<LoggedRover>& rovers, const std::string& id) {
  std::vector<std::string> ids;
  for (const LoggedRover& rover : rovers) {
    ids.push_back(rover.sample.rover_id);
    if (id.empty() || ids.back() == id) return rover;
  }
  throw InputError({}, id.empty() ? "the run has no sample until then"
                                  : fmt::format("--rover {}: the run has no such rover{}", id,
                                                did_you_mean(id, ids)));
}

struct Scene {
  std::vector<PictureSolid> solids;  // without the panels of the rover
  std::vector<PanelFace> panels;
  double reach_m = 1;
};

Scene scene_of(const MissionFiles& files, const Ground& ground,
               const std::vector<LoggedRover>& rovers, const LoggedRover& middle,
               const Vec3& sun_S) {
  const SiteFrame& site = ground.site();
  const Vec3& eye_S_m = middle.sample.p_S_m;
  const double g_mps2 = gravity_mps2(site.body(), site.origin());
  Scene scene;
  const auto add = [&](const Mesh& mesh, const Vec3& colour, bool is_emissive) {
    scene.solids.push_back({mesh, colour, is_emissive});
  };
  for (const LoggedRover& rover : rovers) {
    const auto planned =
        std::ranges::find(files.plan.rovers, rover.sample.rover_id, &PlanRover::id);
    if (planned == files.plan.rovers.end()) continue;
    const RoverModel& model = files.rover_models.at(planned->type);
    const VehicleConfig vehicle = make_vehicle(model.spec, planned->configuration, g_mps2);
    const BodyShape shape(model.shapes, vehicle);
    const bool is_middle = &rover == &middle;
    if (is_middle) scene.reach_m = shape.reach_m();
    for (const auto& solid : shape.solids(part_poses(site, vehicle, rover), eye_S_m)) {
      add(solid.mesh, solid.colour, false);
    }
    for (const auto& face : panel_faces(site, model.power.panels, rover)) {
      if (!face) continue;
      PanelFace about_eye = *face;
      about_eye.centre_m += rover.sample.p_S_m - eye_S_m;
      if (!is_middle) {
        add(face_mesh(about_eye), panel_back, false);
        continue;
      }
      scene.panels.push_back(about_eye);
      scene.reach_m =
          std::max(scene.reach_m, about_eye.centre_m.norm() + about_eye.half_u_m.norm() +
                                      about_eye.half_v_m.norm());
    }
  }
  for (const PlanAsset& planned : files.plan.assets) {
    const StandingAsset asset = stand(planned, files.asset_models.at(planned.type), ground);
    for (const auto& solid : asset.shape.solids({asset.pose}, eye_S_m)) {
      add(solid.mesh, solid.colour, false);
    }
    for (const PanelFace& face : asset.panel_faces(eye_S_m, sun_S)) {
      add(face_mesh(face), panel_back, false);
    }
  }
  return scene;
}

}  // namespace

int picture_command(const PictureOptions& options) {
  const LogReader log(options.folder + "/log.gpkg");
  const MissionFiles files = mission_of(options.folder, log.run());
  const MissionInfo& mission = files.plan.mission;
  const SimTime time = time_of(options.at, log.start());
  if (time < SimTime{} || time > log.last_sample_time()) {
    throw InputError(
        {}, fmt::format("--at {}: the run is from {} to {}", options.at, format_utc(log.start()),
                        format_utc(log.start() + log.last_sample_time())));
  }
  const std::unique_ptr<Ground> ground =
      ground_at(files.terrain, *mission.planet, files.plan.rovers.front().start, mission.seed);
  const std::vector<LoggedRover> rovers = rovers_at(log, time);
  const LoggedRover& rover = chosen(rovers, options.rover);
  const SiteFrame& site = ground->site();
  const Vec3& eye_S_m = rover.sample.p_S_m;
  const Instant utc = log.start() + rover.sample.time;
  const Sunlight sun = sunlight(site.body(), rover.sample.place, utc, 0);
  const Vec3 sun_S = direction_S(site, eye_S_m, sun.seen);
  Scene scene = scene_of(files, *ground, rovers, rover, sun_S);
  const Vec3 up_S = site.up_S(eye_S_m);
  const Vec3 across =
      up_S.cross(sun_S).norm() > 1e-6 ? up_S.cross(sun_S).normalized() : site.east_S(eye_S_m);
  PictureFrame frame;
  frame.towards = sun_S;
  frame.up = sun_S.cross(across);
  frame.centre_m = up_S * (scene.reach_m / 3);
  frame.half_m = frame_reaches * scene.reach_m;
  frame.size_px = options.size_px;
  const double wide_m = neighbours_reaches * scene.reach_m;
  // What may stand before the Sun, and the ground about the rover.
  const double patch_m = 8 * scene.reach_m;
  scene.solids.push_back({ground_mesh(*ground, {eye_S_m, wide_m, sun_S, 0}), ground_grey, false});
  scene.solids.push_back({ground_patch(*ground, eye_S_m, patch_m, 160), ground_grey, false});
  for (const PanelFace& face : scene.panels) {
    scene.solids.push_back({face_mesh(face), face.normal().dot(sun_S) > 0 ? green : panel_back,
                            face.normal().dot(sun_S) > 0});
  }
  const Gpu gpu;
  const Picture picture = draw(gpu, scene.solids, frame);
  std::vector<PictureSolid> alone(
      scene.solids.end() - static_cast<std::ptrdiff_t>(scene.panels.size()), scene.solids.end());
  const int seen = green_pixels(picture), most = green_pixels(draw(gpu, alone, frame));
  write_png(options.file, picture.size_px, picture.size_px, picture.rgb);

  const nlohmann::ordered_json answer{
      {"file", options.file},
      {"rover_id", rover.sample.rover_id},
      {"utc", format_utc(utc)},
      {"sun_azimuth_deg", degrees(sun.seen.azimuth_rad)},
      {"sun_elevation_deg", degrees(sun.seen.elevation_rad)},
      {"green_pixels", seen},
      {"green_pixels_alone", most},
      {"seen_share", most > 0 ? nlohmann::ordered_json(static_cast<double>(seen) / most)
                              : nlohmann::ordered_json(nullptr)}};
  fmt::print("{}\n", nlohmann::ordered_json::array({answer}).dump(2));
  return 0;
}

}  // namespace lsos
