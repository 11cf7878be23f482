// Limbs of a vehicle: how it is placed on them, their motors, and what its posture is measured by.
#include <algorithm>
#include <cmath>

#include "vehicle/drive_power.h"
#include "vehicle/vehicle.h"

namespace lsos {

namespace {

constexpr double load_smoothing_s = 0.1;  // of the loads by which limbs share the weight

}  // namespace

bool Vehicle::stands_level() const { return posture_ && config_.posture && posture_->is_level(); }

std::vector<Vec2> Vehicle::wheel_places_B_m() const {
  std::vector<Vec2> places_B_m;
  for (const WheelLayout::WheelPlace& wheel : layout_.wheels) places_B_m.push_back(wheel.p_B_m);
  for (std::size_t i = 0; i < limb_wheels_.size(); ++i) {
    places_B_m[limb_wheels_[i]] = posture_->hubs_B_m()[i].head<2>();
  }
  return places_B_m;
}

// On limbs, the chassis is as high over the middle of the ground under the wheels as its stance
// says; with posture control each limb reaches to the ground under its own wheel.
Vehicle::Placement Vehicle::on_feet(const Vec3& p_SB_m, const Mat3& R_SB,
                                    const std::vector<Vec3>& feet_S_m) const {
  Placement placement{p_SB_m, {}};
  for (const LinkConfig& link : config_.links) placement.joints.push_back(link.initial);
  if (!posture_) return placement;
  const auto count = static_cast<double>(limb_wheels_.size());
  std::vector<Vec3> hubs_B_m;  // over the ground, seen from p_SB_m
  double rise_m = 0;
  for (std::size_t i = 0; i < limb_wheels_.size(); ++i) {
    const std::size_t wheel = limb_wheels_[i];
    const Vec3 foot_B_m = R_SB.transpose() * (feet_S_m[wheel] - p_SB_m);
    hubs_B_m.push_back(posture_->hubs_B_m()[i]);
    const double nominal_m = hubs_B_m[i].z();
    hubs_B_m[i].z() = foot_B_m.z() + parts_[wheel].shape->radius_m;
    rise_m += (hubs_B_m[i].z() - nominal_m) / count;
  }
  placement.p_SB_m += rise_m * R_SB.col(2);
  if (!config_.posture) return placement;
  for (std::size_t i = 0; i < limb_wheels_.size(); ++i) {
    const std::vector<int>& joints = config_.limbs[i].joints;
    std::vector<double> angles_rad;
    for (const int joint : joints) {
      angles_rad.push_back(placement.joints[static_cast<std::size_t>(joint)]);
    }
    const Vec3 goal_B_m = hubs_B_m[i] - rise_m * Vec3::UnitZ();
    angles_rad = posture_->chains()[i].reach(goal_B_m, angles_rad).angles_rad;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      placement.joints[static_cast<std::size_t>(joints[j])] = angles_rad[j];
    }
  }
  return placement;
}

// Commands each limb to the angles at which its joints are.
void Vehicle::hold_limbs() {
  for (std::size_t i = 0; i < limb_joints_.size(); ++i) {
    for (std::size_t j = 0; j < limb_joints_[i].size(); ++j) {
      limb_joints_[i][j].setpoint_rad = bodies_.joint_position(config_.limbs[i].joints[j]);
    }
  }
  const double share_n = config_.mass_kg() * gravity_S_mps2_.norm() /
                         static_cast<double>(std::max<std::size_t>(limb_joints_.size(), 1));
  std::ranges::fill(limb_loads_n_, share_n);
  if (posture_) posture_->wake();
}

void Vehicle::set_posture(const std::vector<Vec3>& hubs_B_m, bool is_level, double duration_s) {
  posture_->move_to(hubs_B_m, is_level, duration_s);
}

std::vector<std::vector<double>> Vehicle::limb_angles_rad() const {
  std::vector<std::vector<double>> angles_rad;
  for (const std::vector<LimbJointState>& limb : limb_joints_) {
    std::vector<double>& angles = angles_rad.emplace_back();
    for (const LimbJointState& joint : limb) angles.push_back(joint.setpoint_rad);
  }
  return angles_rad;
}

void Vehicle::update_posture() {
  PostureControl::Input input;
  input.up_B = up_B();
  input.loads_n = limb_loads_n_;
  input.angles_rad = limb_angles_rad();
  input.is_driving = !command_.is_braking;
  input.is_fixed = limbs_locked();
  const std::vector<std::vector<double>> rates_radps = posture_->rates_radps(input);
  for (std::size_t i = 0; i < limb_joints_.size(); ++i) {
    for (std::size_t j = 0; j < limb_joints_[i].size(); ++j) {
      limb_joints_[i][j].rate_radps = rates_radps[i][j];
    }
  }
}

double Vehicle::apply_limbs(double step_s) {
  if (steps_ % posture_steps_ == 0) update_posture();
  const double load_share = std::min(1.0, step_s / load_smoothing_s);
  double electrical_w = 0;
  for (std::size_t i = 0; i < limb_joints_.size(); ++i) {
    limb_loads_n_[i] += load_share * (wheels_[limb_wheels_[i]].load_n - limb_loads_n_[i]);
    for (std::size_t j = 0; j < limb_joints_[i].size(); ++j) {
      LimbJointState& joint = limb_joints_[i][j];
      const int link = config_.limbs[i].joints[j];
      const LimbMotor& motor = config_.links[static_cast<std::size_t>(link)].limb->motor;
      const bool is_turning = joint.rate_radps != 0;
      const double torque_max_n_m = is_turning ? motor.torque_max_n_m : motor.brake_torque_max_n_m;
      const double q = bodies_.joint_position(link), rate = bodies_.joint_velocity(link);
      // A motor or brake at its greatest torque gives way.
      const double slack_rad = torque_max_n_m / motor.stiffness_n_m_prad;
      joint.setpoint_rad =
          std::clamp(joint.setpoint_rad + joint.rate_radps * step_s, q - slack_rad, q + slack_rad);
      const double torque_n_m = std::clamp(motor.stiffness_n_m_prad * (joint.setpoint_rad - q) +
                                               motor.damping_n_m_sprad * (joint.rate_radps - rate),
                                           -torque_max_n_m, torque_max_n_m);
      bodies_.add_joint_force(link, torque_n_m);
      work_.limbs_j += torque_n_m * rate * step_s;
      if (is_turning) electrical_w += limb_power_w(motor, torque_n_m, joint.rate_radps);
    }
  }
  return electrical_w;
}

void Vehicle::set_limb_locked(int link, bool is_locked) {
  for (std::size_t i = 0; i < limb_joints_.size(); ++i) {
    for (std::size_t j = 0; j < limb_joints_[i].size(); ++j) {
      if (config_.limbs[i].joints[j] == link) limb_joints_[i][j].is_locked = is_locked;
    }
  }
}

std::vector<std::vector<bool>> Vehicle::limbs_locked() const {
  std::vector<std::vector<bool>> locked;
  for (const std::vector<LimbJointState>& limb : limb_joints_) {
    std::vector<bool>& joints = locked.emplace_back();
    for (const LimbJointState& joint : limb) joints.push_back(joint.is_locked);
  }
  return locked;
}

Vec3 Vehicle::up_B() const {
  const LinkMotion& chassis = bodies_.motion(Multibody::chassis);
  return chassis.R_SL.transpose() * ground_->site().up_S(chassis.p_C_S_m);
}

// The ground centre of the wheels, see reference_B_m().
Vec3 Vehicle::ground_center_S_m() const {
  const Vec3 down = -bodies_.motion(Multibody::chassis).R_SL.col(2);
  Vec3 sum_m = Vec3::Zero();
  for (const std::size_t wheel : limb_wheels_) {
    sum_m += bodies_.motion(parts_[wheel].link).p_C_S_m + parts_[wheel].shape->radius_m * down;
  }
  return sum_m / static_cast<double>(limb_wheels_.size());
}

Vec3 Vehicle::ground_center_velocity_S_mps() const {
  const LinkMotion& chassis = bodies_.motion(Multibody::chassis);
  const Vec3 turning = -chassis.omega_S_radps.cross(chassis.R_SL.col(2));
  Vec3 sum_mps = Vec3::Zero();
  for (const std::size_t wheel : limb_wheels_) {
    sum_mps +=
        bodies_.motion(parts_[wheel].link).v_C_S_mps + parts_[wheel].shape->radius_m * turning;
  }
  return sum_mps / static_cast<double>(limb_wheels_.size());
}

}  // namespace lsos
