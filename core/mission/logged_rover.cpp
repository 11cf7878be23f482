#include "mission/logged_rover.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

PartPose chassis_pose(const SiteFrame& site, const SampleRow& sample) {
  const Vec3& p_S_m = sample.p_S_m;
  const Vec3 up = site.up_S(p_S_m);
  const Vec3 level = std::sin(sample.heading_rad) * site.east_S(p_S_m) +
                     std::cos(sample.heading_rad) * site.north_S(p_S_m);
  const Vec3 ahead = std::cos(sample.pitch_rad) * level + std::sin(sample.pitch_rad) * up;
  const Vec3 level_left = up.cross(level);
  const Vec3 left =
      std::cos(sample.roll_rad) * level_left + std::sin(sample.roll_rad) * ahead.cross(level_left);
  PartPose pose{p_S_m, {}};
  pose.R_SB << ahead, left, ahead.cross(left);
  return pose;
}

}  // namespace

std::vector<PartPose> part_poses(const SiteFrame& site, const VehicleConfig& vehicle,
                                 const LoggedRover& logged) {
  std::vector<double> joints;
  for (const LinkConfig& link : vehicle.links) {
    const auto row = std::ranges::find(logged.joints, link.name, &JointRow::joint);
    const bool is_known = row != logged.joints.end();
    const bool is_angle = link.joint == JointType::revolute;
    joints.push_back(!is_known ? 0 : is_angle ? row->angle_rad : row->extension_m);
  }
  return part_poses(vehicle, chassis_pose(site, logged.sample), joints);
}

std::vector<std::optional<PanelFace>> panel_faces(const SiteFrame& site,
                                                  std::span<const PanelSpec> panels,
                                                  const LoggedRover& logged) {
  const PartPose chassis = chassis_pose(site, logged.sample);
  std::vector<std::optional<PanelFace>> faces;
  for (const PanelSpec& panel : panels) {
    const auto row = std::ranges::find(logged.panels, panel.name, &PanelRow::panel);
    if (row == logged.panels.end() || std::isnan(row->azimuth_rad)) {
      faces.emplace_back();
      continue;
    }
    const Vec3 normal_S =
        direction_S(site, logged.sample.p_S_m, {row->azimuth_rad, row->elevation_rad});
    const PanelAngles angles = facing(panel, panel.rest, chassis.R_SB.transpose() * normal_S);
    const PanelPose at = pose(panel, angles);
    faces.push_back(PanelFace{chassis.R_SB * at.p_B_m, chassis.R_SB * at.half_u_B_m,
                              chassis.R_SB * at.half_v_B_m});
  }
  return faces;
}

}  // namespace lsos
