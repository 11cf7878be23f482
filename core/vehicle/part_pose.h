// Poses of a vehicle's parts, for everything that is fixed to one of them.
#pragma once

#include <vector>

#include "planet/site_frame.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Transform from frame B with the vehicle at rest to the site frame now, for points fixed to one
// part.
struct PartPose {
  Vec3 p_S_m = Vec3::Zero();
  Mat3 R_SB = Mat3::Identity();

  Vec3 point_S_m(const Vec3& p_B_m) const { return p_S_m + R_SB * p_B_m; }
};

// Pose of a chassis with its reference point at `p_S_m`. Heading is clockwise from true north,
// pitch positive nose up, roll positive right side down, about the local vertical there.
PartPose chassis_pose(const SiteFrame& site, const Vec3& p_S_m, double heading_rad,
                      double pitch_rad, double roll_rad);

// Position of each link's joint on its parent with all joints at 0, frame B.
std::vector<Vec3> joints_at_rest_B_m(const VehicleConfig& config);
// Centres of mass with all joints at 0, frame B: the chassis first, then each link.
std::vector<Vec3> centres_at_rest_B_m(const VehicleConfig& config);

// Poses of the chassis, then of each link, for joint positions in m or rad, in order of the links.
std::vector<PartPose> part_poses(const VehicleConfig& config, const PartPose& chassis,
                                 const std::vector<double>& joints);

// The reference point in frame B for joint positions as above: the origin, but on limbs the ground
// centre of the wheels wherever they stand under the chassis.
Vec3 reference_B_m(const VehicleConfig& config, const std::vector<double>& joints);

}  // namespace lsos
