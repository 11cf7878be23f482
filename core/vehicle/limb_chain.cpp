#include "vehicle/limb_chain.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "vehicle/part_pose.h"

namespace lsos {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// Damping of the least squares: lengthens no step noticeably, and bounds it where the limb is
// stretched. Metres per radian for the hub, none for the axis.
constexpr double hub_damping_m = 0.02, tilt_damping = 0.02;

// Damped inverse of a matrix with more columns than rows (Wampler 1986).
Matrix damped_inverse(const Matrix& jacobian, double damping) {
  const Matrix normal = jacobian * jacobian.transpose() +
                        damping * damping * Matrix::Identity(jacobian.rows(), jacobian.rows());
  return jacobian.transpose() * normal.ldlt().solve(Matrix::Identity(normal.rows(), normal.cols()));
}

constexpr int solver_steps_max = 200;
constexpr double step_max_rad = 0.2, converged_rad = 1e-7;

}  // namespace

LimbChain::LimbChain(const VehicleConfig& vehicle, const LimbConfig& limb) {
  const std::vector<Vec3> joints_B_m = joints_at_rest_B_m(vehicle);
  for (const int link : limb.joints) {
    const LinkConfig& config = vehicle.links[static_cast<std::size_t>(link)];
    joints_.push_back({joints_B_m[static_cast<std::size_t>(link)], config.axis,
                       config.limb->angle_min_rad, config.limb->angle_max_rad});
  }
  at_rest_.hub_B_m = joints_B_m[static_cast<std::size_t>(limb.wheel)];
}

LimbPose LimbChain::pose(const std::vector<double>& angles_rad) const {
  LimbPose pose = at_rest_;
  for (std::size_t i = joints_.size(); i-- > 0;) {
    const Eigen::AngleAxisd turn(angles_rad[i], joints_[i].axis_B);
    pose.hub_B_m = joints_[i].p_B_m + turn * (pose.hub_B_m - joints_[i].p_B_m);
    pose.up_B = turn * pose.up_B;
  }
  return pose;
}

std::vector<double> LimbChain::step_rad(const std::vector<double>& angles_rad, const Vec3& hub_B_m,
                                        const std::vector<bool>& is_fixed) const {
  const LimbPose now = pose(angles_rad);
  const auto count = static_cast<Eigen::Index>(joints_.size());
  Matrix hub(3, count), axis(2, count);
  Mat3 R = Mat3::Identity();
  Vec3 shift_m = Vec3::Zero();  // a point p of the chain at rest is now at R p + shift
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const Vec3 axis_B = R * joints_[i].axis_B, p_B_m = R * joints_[i].p_B_m + shift_m;
    hub.col(column) = axis_B.cross(now.hub_B_m - p_B_m);
    axis.col(column) = axis_B.cross(now.up_B).head<2>();
    if (!is_fixed.empty() && is_fixed[i]) {
      hub.col(column).setZero();
      axis.col(column).setZero();
    }
    R = R * Eigen::AngleAxisd(angles_rad[i], joints_[i].axis_B).toRotationMatrix();
    shift_m = p_B_m - R * joints_[i].p_B_m;
  }
  const Matrix to_hub = damped_inverse(hub, hub_damping_m);
  Vector step = to_hub * hub_B_m;
  // The axis turns only by what leaves the hub where it is.
  const Matrix free = Matrix::Identity(count, count) - to_hub * hub;
  const Vector tilt = -now.up_B.head<2>() - axis * step;
  step += free * damped_inverse(axis * free, tilt_damping) * tilt;
  return {step.begin(), step.end()};
}

LimbChain::Reach LimbChain::reach(const Vec3& hub_B_m, std::vector<double> from_rad,
                                  const std::vector<bool>& is_fixed) const {
  Reach reach{std::move(from_rad)};
  for (int k = 0; k < solver_steps_max; ++k) {
    const std::vector<double> step =
        step_rad(reach.angles_rad, hub_B_m - pose(reach.angles_rad).hub_B_m, is_fixed);
    double longest_rad = 0, moved_rad = 0;
    for (const double turn : step) longest_rad = std::max(longest_rad, std::abs(turn));
    const double share = longest_rad > step_max_rad ? step_max_rad / longest_rad : 1;
    reach.limiting_joint = -1;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const double before = reach.angles_rad[i], wanted = before + share * step[i];
      reach.angles_rad[i] = std::clamp(wanted, joints_[i].angle_min_rad, joints_[i].angle_max_rad);
      if (reach.angles_rad[i] != wanted) reach.limiting_joint = static_cast<int>(i);
      moved_rad = std::max(moved_rad, std::abs(reach.angles_rad[i] - before));
    }
    if (moved_rad < converged_rad) break;
  }
  const LimbPose end = pose(reach.angles_rad);
  reach.error_m = (end.hub_B_m - hub_B_m).norm();
  reach.lean_rad = std::atan2(end.up_B.head<2>().norm(), end.up_B.z());
  reach.is_there = reach.error_m <= hub_reached_m &&
                   (!can_hold_upright() || reach.lean_rad <= upright_within_rad);
  return reach;
}

std::vector<LimbChain> limb_chains(const VehicleConfig& vehicle) {
  std::vector<LimbChain> chains;
  for (const LimbConfig& limb : vehicle.limbs) chains.emplace_back(vehicle, limb);
  return chains;
}

}  // namespace lsos
