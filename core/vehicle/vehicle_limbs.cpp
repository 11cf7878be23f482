// Limbs of a vehicle: their motors, and what its posture is measured by.
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

void Vehicle::stand_on(const std::vector<Vec3>& hubs_B_m, bool is_level) {
  posture_->stand_on(hubs_B_m, is_level);
}

std::vector<std::vector<double>> Vehicle::limb_angles_rad() const {
  std::vector<std::vector<double>> angles_rad;
  for (const std::vector<LimbJointState>& limb : limb_joints_) {
    std::vector<double>& angles = angles_rad.emplace_back();
    for (const LimbJointState& joint : limb) angles.push_back(joint.setpoint_rad);
  }
  return angles_rad;
}

std::vector<std::vector<double>> Vehicle::limb_positions_rad() const {
  std::vector<std::vector<double>> angles_rad;
  for (const LimbConfig& limb : config_.limbs) {
    std::vector<double>& angles = angles_rad.emplace_back();
    for (const int joint : limb.joints) angles.push_back(bodies_.joint_position(joint));
  }
  return angles_rad;
}

std::vector<Vec3> Vehicle::hubs_B_m() const {
  const std::vector<std::vector<double>> angles_rad = limb_positions_rad();
  std::vector<Vec3> hubs;
  for (std::size_t i = 0; i < angles_rad.size(); ++i) {
    hubs.push_back(posture_->chains()[i].pose(angles_rad[i]).hub_B_m);
  }
  return hubs;
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
      if (is_turning) electrical_w += limb_power_w(motor, torque_n_m, rate);
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
  if (posture_ && !is_locked) posture_->wake();  // it does what it could not
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
