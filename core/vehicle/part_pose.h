// Where the parts of a vehicle are, for all that is fixed to one of them.
#pragma once

#include <vector>

#include "planet/site_frame.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Carries what is fixed to a part from frame B, as it is at rest, to where it is now.
struct PartPose {
  Vec3 p_S_m = Vec3::Zero();
  Mat3 R_SB = Mat3::Identity();

  Vec3 point_S_m(const Vec3& p_B_m) const { return p_S_m + R_SB * p_B_m; }
};

// Of a chassis with its reference point there. Heading clockwise from true north, nose up and right
// side down positive, about the local vertical.
PartPose chassis_pose(const SiteFrame& site, const Vec3& p_S_m, double heading_rad,
                      double pitch_rad, double roll_rad);

// Joints at rest, all at 0, frame B: of each link where it hangs on its parent.
std::vector<Vec3> joints_at_rest_B_m(const VehicleConfig& config);
// Centres of mass at rest with all joints at 0, frame B: the chassis first, then each link.
std::vector<Vec3> centres_at_rest_B_m(const VehicleConfig& config);

// Of the chassis, then of each link, for joints that stand so (m or rad, in order of the links).
std::vector<PartPose> part_poses(const VehicleConfig& config, const PartPose& chassis,
                                 const std::vector<double>& joints);

}  // namespace lsos
