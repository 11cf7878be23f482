#include "vehicle/part_pose.h"

#include <cmath>

namespace lsos {

PartPose chassis_pose(const SiteFrame& site, const Vec3& p_S_m, double heading_rad,
                      double pitch_rad, double roll_rad) {
  const Vec3 up = site.up_S(p_S_m);
  const Vec3 level = site.horizontal_S(heading_rad, p_S_m);
  const Vec3 ahead = std::cos(pitch_rad) * level + std::sin(pitch_rad) * up;
  const Vec3 level_left = up.cross(level);
  const Vec3 left = std::cos(roll_rad) * level_left + std::sin(roll_rad) * ahead.cross(level_left);
  PartPose pose{p_S_m, {}};
  pose.R_SB << ahead, left, ahead.cross(left);
  return pose;
}

std::vector<Vec3> joints_at_rest_B_m(const VehicleConfig& config) {
  std::vector<Vec3> joints_B_m;
  for (const LinkConfig& link : config.links) {
    const Vec3 parent_B_m =
        link.parent < 0 ? Vec3::Zero() : joints_B_m[static_cast<std::size_t>(link.parent)];
    joints_B_m.push_back(parent_B_m + link.p_PJ_m);
  }
  return joints_B_m;
}

std::vector<Vec3> centres_at_rest_B_m(const VehicleConfig& config) {
  const std::vector<Vec3> joints_B_m = joints_at_rest_B_m(config);
  std::vector<Vec3> centres_B_m{config.p_BC_m};
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    centres_B_m.push_back(joints_B_m[i] + config.links[i].p_JC_m);
  }
  return centres_B_m;
}

std::vector<PartPose> part_poses(const VehicleConfig& config, const PartPose& chassis,
                                 const std::vector<double>& joints) {
  std::vector<PartPose> poses{chassis};
  const std::vector<Vec3> joints_B_m = joints_at_rest_B_m(config);
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    const LinkConfig& link = config.links[i];
    const bool is_on_chassis = link.parent < 0;
    const auto parent = static_cast<std::size_t>(link.parent);
    const PartPose& on = poses[is_on_chassis ? 0 : parent + 1];
    PartPose pose = on;
    if (link.joint == JointType::prismatic) {
      pose.p_S_m += on.R_SB * (joints[i] * link.axis);
    } else {
      // The part turns about its joint, which stays in place.
      pose.R_SB = on.R_SB * Eigen::AngleAxisd(joints[i], link.axis).toRotationMatrix();
      pose.p_S_m = on.point_S_m(joints_B_m[i]) - pose.R_SB * joints_B_m[i];
    }
    poses.push_back(pose);
  }
  return poses;
}

Vec3 reference_B_m(const VehicleConfig& config, const std::vector<double>& joints) {
  Vec3 sum_m = Vec3::Zero();
  if (config.limbs.empty()) return sum_m;
  const std::vector<PartPose> poses = part_poses(config, {}, joints);
  const std::vector<Vec3> joints_B_m = joints_at_rest_B_m(config);
  for (const LimbConfig& limb : config.limbs) {
    const auto wheel = static_cast<std::size_t>(limb.wheel);
    const double radius_m = config.links[wheel].wheel->radius_m;
    sum_m += poses[wheel + 1].point_S_m(joints_B_m[wheel]) - radius_m * Vec3::UnitZ();
  }
  return sum_m / static_cast<double>(config.limbs.size());
}

}  // namespace lsos
