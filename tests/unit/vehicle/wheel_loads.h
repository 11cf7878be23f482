// Wheel loads at rest on level ground, from the geometry alone: the depth of each rim below the
// ground, from the joint positions, times the wheel's stiffness.
#pragma once

#include <cmath>
#include <map>
#include <string>

#include "vehicle/vehicle.h"

namespace lsos::test {

// Lets two more seconds pass with brakes on, until nothing oscillates any more.
inline void settle(Vehicle& vehicle) {
  for (int i = 0; i < 20; ++i) vehicle.advance(exchange_period);
}

// Rotation from the vehicle's axes to those of a site on level ground, near the site's origin.
inline Mat3 attitude(const VehicleReport& report) {
  const Mat3 yaw = Eigen::AngleAxisd(report.yaw_rad, Vec3::UnitZ()).toRotationMatrix();
  const Mat3 pitch = Eigen::AngleAxisd(-report.pitch_rad, Vec3::UnitY()).toRotationMatrix();
  return yaw * pitch * Eigen::AngleAxisd(report.roll_rad, Vec3::UnitX()).toRotationMatrix();
}

inline std::map<std::string, double> wheel_loads_n(Vehicle& vehicle) {
  const VehicleReport report = vehicle.report();
  const std::vector<LinkConfig>& links = vehicle.config().links;
  const std::vector<double> joints = vehicle.joint_positions();
  std::vector<Vec3> p_S_m(links.size());
  std::vector<Mat3> R_SL(links.size());
  std::map<std::string, double> loads_n;
  const Vec3 chassis_S_m =
      report.p_S_m - attitude(report) * reference_B_m(vehicle.config(), joints);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LinkConfig& link = links[i];
    const auto parent = static_cast<std::size_t>(link.parent);
    const Mat3 R_SP = link.parent < 0 ? attitude(report) : R_SL[parent];
    const Vec3 p_P_S_m = link.parent < 0 ? chassis_S_m : p_S_m[parent];
    const bool turns = link.joint == JointType::revolute;
    p_S_m[i] = p_P_S_m + R_SP * (link.p_PJ_m + (turns ? 0.0 : joints[i]) * link.axis);
    R_SL[i] = R_SP;
    // Spin does not move the rim's lowest point.
    if (turns && !link.wheel) R_SL[i] *= Eigen::AngleAxisd(joints[i], link.axis).toRotationMatrix();
    if (!link.wheel) continue;
    // Height of the lowest point of a leaning disc below its centre: r sqrt(1 - lean^2).
    const double lean = R_SL[i].col(1).z();
    const double depth_m = link.wheel->radius_m * std::sqrt(1 - lean * lean) - p_S_m[i].z();
    loads_n[link.name] = std::max(0.0, depth_m) * link.wheel->normal_stiffness_npm;
  }
  return loads_n;
}

inline double sum(const std::map<std::string, double>& loads_n) {
  double sum_n = 0;
  for (const auto& [name, load_n] : loads_n) sum_n += load_n;
  return sum_n;
}

}  // namespace lsos::test
