#include "vehicle/part_pose.h"

namespace lsos {

std::vector<Vec3> centres_at_rest_B_m(const VehicleConfig& config) {
  std::vector<Vec3> joints_B_m, centres_B_m{config.p_BC_m};
  for (const LinkConfig& link : config.links) {
    const Vec3 parent_B_m =
        link.parent < 0 ? Vec3::Zero() : joints_B_m[static_cast<std::size_t>(link.parent)];
    joints_B_m.push_back(parent_B_m + link.p_PJ_m);
    centres_B_m.push_back(joints_B_m.back() + link.p_JC_m);
  }
  return centres_B_m;
}

std::vector<PartPose> part_poses(const VehicleConfig& config, const PartPose& chassis,
                                 const std::vector<double>& joints) {
  std::vector<PartPose> poses{chassis};
  std::vector<Vec3> joints_B_m;
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    const LinkConfig& link = config.links[i];
    const bool is_on_chassis = link.parent < 0;
    const auto parent = static_cast<std::size_t>(link.parent);
    joints_B_m.push_back((is_on_chassis ? Vec3::Zero() : joints_B_m[parent]) + link.p_PJ_m);
    const PartPose& on = poses[is_on_chassis ? 0 : parent + 1];
    PartPose pose = on;
    if (link.joint == JointType::prismatic) {
      pose.p_S_m += on.R_SB * (joints[i] * link.axis);
    } else {
      // Turned about the joint, which stays where it is.
      pose.R_SB = on.R_SB * Eigen::AngleAxisd(joints[i], link.axis).toRotationMatrix();
      pose.p_S_m = on.point_S_m(joints_B_m[i]) - pose.R_SB * joints_B_m[i];
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace lsos
