#include "vehicle/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "vehicle/plane_fit.h"

namespace lsos {

namespace {

constexpr double underside_spacing_m = 0.5;  // a rock or crest between points is not felt
// Time for which a contact plane serves. The search for the contact mostly settles in it
// (search_smoothing_s): on crests of up to 1.7 times the wheel's curvature with steps of 10 ms, 1.9
// times with 5 ms.
constexpr SimTime contact_plane_period{20'000};

}  // namespace

Vehicle::Vehicle(const VehicleConfig& config, const Ground& ground)
    : config_(config),
      ground_(&ground),
      probe_(ground),
      bodies_(config),
      layout_(wheel_layout(config)),
      centres_B_m_(centres_at_rest_B_m(config)),
      contact_plane_steps_(std::max(0, static_cast<int>(contact_plane_period / config.step) - 1)),
      wheels_(layout_.wheels.size()),
      steerings_(layout_.steerings.size()) {
  for (std::size_t i = 0; i < config_.links.size(); ++i) {
    if (config_.links[i].spring) spring_links_.push_back(static_cast<int>(i));
  }
  if (!config_.limbs.empty()) posture_.emplace(config_);
  posture_steps_ = posture_ ? posture_->steps() : 1;
  for (const LimbConfig& limb : config_.limbs) {
    const auto found =
        std::ranges::find(layout_.wheels, limb.wheel, &WheelLayout::WheelPlace::link);
    limb_wheels_.push_back(static_cast<std::size_t>(found - layout_.wheels.begin()));
    limb_joints_.emplace_back(limb.joints.size());
  }
  limb_loads_n_.assign(config_.limbs.size(), 0.0);
  const double g_mps2 = ground.site().gravity_S_mps2(Vec3::Zero()).norm();
  const double share_n = config_.mass_kg() * g_mps2 / static_cast<double>(layout_.wheels.size());
  for (const WheelLayout::WheelPlace& place : layout_.wheels) {
    const LinkConfig& link = config_.links[static_cast<std::size_t>(place.link)];
    parts_.push_back({place.link, &*link.wheel, link.drive ? &*link.drive : nullptr, {}, {}});
    wheels_[parts_.size() - 1].mode = link.wheel_mode;
    for (const Soil& soil : ground.soils()) {
      const WheelSoil& on_soil = parts_.back().soils.emplace_back(soil, *link.wheel, g_mps2);
      parts_.back().rolling_radii_m.push_back(on_soil.rolling_radius_m(share_n));
    }
  }
  const Vec3& size_m = config_.chassis_size_m;
  const double along = std::ceil(size_m.x() / underside_spacing_m);
  const double across = std::ceil(size_m.y() / underside_spacing_m);
  for (double i = 0; i <= along; ++i) {
    for (double k = 0; k <= across; ++k) {
      underside_B_m_.push_back({(i / along - 0.5) * size_m.x(), (k / across - 0.5) * size_m.y(),
                                config_.chassis_clearance_m});
    }
  }
}

double Vehicle::potential_j() const {
  return bodies_.potential_j(
      ground_->site().gravity_S_mps2(bodies_.motion(Multibody::chassis).p_C_S_m));
}

Vec3 Vehicle::reference_point_S_m() const {
  const LinkMotion& chassis = bodies_.motion(Multibody::chassis);
  if (posture_) return ground_center_S_m();
  return chassis.p_C_S_m - chassis.R_SL * config_.p_BC_m;
}

Vec3 Vehicle::reference_velocity_S_mps() const {
  if (posture_) return ground_center_velocity_S_mps();
  return bodies_.motion(Multibody::chassis).velocity_at(reference_point_S_m());
}

double Vehicle::speed_along_ground_mps() const {
  const Vec3 v_S_mps = reference_velocity_S_mps();
  return (v_S_mps - v_S_mps.dot(ground_normal_S_) * ground_normal_S_).norm();
}

void Vehicle::set_wheel_mode(std::size_t wheel, WheelMode mode) {
  WheelState& state = wheels_[wheel];
  state.mode = mode;
  state.brake_anchor_rad = bodies_.joint_position(layout_.wheels[wheel].link);
  state.servo_integral_rad = 0;
}

void Vehicle::set_steering_stuck(std::size_t steering, bool is_stuck) {
  SteeringState& state = steerings_[steering];
  state.is_stuck = is_stuck;
  state.target_rad = state.setpoint_rad;
}

void Vehicle::command(const DriveCommand& command) {
  const bool begins_braking = command.is_braking && !command_.is_braking;
  const bool stops_braking = !command.is_braking && command_.is_braking;
  command_ = command;
  if (command.is_braking) {
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
      if (begins_braking && wheels_[i].mode != WheelMode::locked)
        wheels_[i].brake_anchor_rad = bodies_.joint_position(layout_.wheels[i].link);
      wheels_[i].spin_target_radps = wheels_[i].servo_integral_rad = 0;
    }
    return;
  }
  if (stops_braking) {
    // The motors take over what the brakes held, so that the vehicle does not roll back.
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
      const DriveMotor* motor = parts_[i].motor;
      if (motor == nullptr || motor->servo_integral_n_m_prad <= 0) continue;
      wheels_[i].servo_integral_rad = wheels_[i].torque_n_m / motor->servo_integral_n_m_prad;
    }
  }
  std::vector<double> now_rad;
  std::vector<bool> are_stuck;
  for (const SteeringState& steering : steerings_) {
    now_rad.push_back(steering.setpoint_rad);
    are_stuck.push_back(steering.is_stuck);
  }
  const WheelTargets targets = wheel_targets(layout_, command, now_rad, are_stuck);
  for (std::size_t i = 0; i < steerings_.size(); ++i) {
    steerings_[i].target_rad = targets.steering_angle_rad[i];
  }
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    wheels_[i].spin_target_radps = targets.spin_radps[i];
  }
}

// Gravity is constant within a period: the local vertical turns by less than 1e-6 rad.
void Vehicle::update_gravity() {
  gravity_S_mps2_ = ground_->site().gravity_S_mps2(bodies_.motion(Multibody::chassis).p_C_S_m);
}

void Vehicle::advance(SimTime period) {
  const double step_s = seconds(config_.step), before_j = drive_j_;
  is_chassis_on_ground_ = false;
  update_chassis_near_ground();
  update_gravity();
  contact_planes_.assign(wheels_.size(), {});
  for (SimTime t{}; t < period && fault_.empty(); t += config_.step) step(step_s);
  drive_w_ = (drive_j_ - before_j) / seconds(period);
}

void Vehicle::halt() {
  command({});
  bodies_.halt();
  drive_w_ = 0;
  for (WheelState& wheel : wheels_) wheel.slip = not_modelled;
  for (std::vector<LimbJointState>& limb : limb_joints_) {
    for (LimbJointState& joint : limb) joint.rate_radps = 0;
  }
}

VehicleReport Vehicle::report() {
  const SiteFrame& site = ground_->site();
  VehicleReport report;
  report.p_S_m = reference_point_S_m();
  report.v_S_mps = reference_velocity_S_mps();
  report.is_finite = fault_.empty();
  if (!report.is_finite) return report;
  const Vec3 up = site.up_S(report.p_S_m);
  const Mat3& R_SB = bodies_.motion(Multibody::chassis).R_SL;
  const Vec3 ahead = R_SB.col(0), left = R_SB.col(1);
  const double heading = site.azimuth_rad(ahead, report.p_S_m);
  report.heading_rad = heading < 0 ? heading + 2 * std::numbers::pi : heading;
  if (report.heading_rad >= 2 * std::numbers::pi) report.heading_rad = 0;
  report.pitch_rad = std::asin(std::clamp(ahead.dot(up), -1.0, 1.0));
  // Roll about the nose: right side down lifts the left side.
  report.roll_rad = std::atan2(left.dot(up), R_SB.col(2).dot(up));
  report.yaw_rad = std::atan2(ahead.y(), ahead.x());
  const GroundSample under = probe_.sample(report.p_S_m);
  report.elevation_m = under.elevation_m;
  report.speed_mps = speed_along_ground_mps();
  report.yaw_rate_radps = bodies_.motion(Multibody::chassis).omega_S_radps.dot(up);
  report.is_chassis_on_ground = is_chassis_on_ground_;

  std::vector<Vec3> feet_S_m;
  double slip_sum = 0, sinkage_sum_m = 0;
  int slipping = 0, touching = 0;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Vec3& hub_S_m = bodies_.motion(layout_.wheels[i].link).p_C_S_m;
    const GroundSample ground = probe_.sample(hub_S_m);
    report.is_on_ground_data &= ground.is_ground();
    if (ground.is_ground()) feet_S_m.push_back(hub_S_m - ground.gap_m * site.up_S(hub_S_m));
    const WheelState& wheel = wheels_[i];
    if (wheel.load_n <= 0) continue;
    ++touching;
    sinkage_sum_m += wheel.sinkage_m;
    if (std::isnan(wheel.slip) || wheel.mode != WheelMode::driven) continue;
    ++slipping;
    slip_sum += wheel.slip;
    if (!(std::abs(report.slip_max) >= std::abs(wheel.slip))) report.slip_max = wheel.slip;
  }
  if (touching > 0) report.sinkage_m = sinkage_sum_m / touching;
  if (slipping > 0) report.slip = slip_sum / slipping;
  report.incline_pitch_rad = report.pitch_rad;
  report.incline_roll_rad = report.roll_rad;
  if (feet_S_m.size() >= 3) {
    const Vec3 normal_S = fit_plane(feet_S_m, up).normal;
    report.slope_rad = std::atan2(normal_S.cross(up).norm(), normal_S.dot(up));
    if (stands_level()) {
      const Vec3 along = left.cross(normal_S).normalized(), across = normal_S.cross(along);
      report.incline_pitch_rad = std::asin(std::clamp(along.dot(up), -1.0, 1.0));
      report.incline_roll_rad = std::atan2(across.dot(up), normal_S.dot(up));
    }
  }
  return report;
}

std::vector<PartPose> Vehicle::part_poses() const {
  std::vector<PartPose> poses;
  for (std::size_t i = 0; i < centres_B_m_.size(); ++i) {
    const LinkMotion& part = bodies_.motion(static_cast<int>(i) - 1);
    poses.push_back({part.p_C_S_m - part.R_SL * centres_B_m_[i], part.R_SL});
  }
  return poses;
}

std::vector<double> Vehicle::joint_positions() const {
  std::vector<double> positions;
  for (std::size_t i = 0; i < config_.links.size(); ++i) {
    positions.push_back(bodies_.joint_position(static_cast<int>(i)));
  }
  return positions;
}

void Vehicle::archive(Archive& a) {
  a.tag("vehicle");
  // The rover's script says how many there are of these.
  const auto counts = [&] {
    std::vector<std::size_t> all{wheels_.size(), steerings_.size(), limb_loads_n_.size()};
    for (const auto& limb : limb_joints_) all.push_back(limb.size());
    return all;
  };
  const std::vector<std::size_t> before = counts();
  if (posture_) LSOS_ARCHIVE(a, *posture_, limb_joints_, limb_loads_n_);
  LSOS_ARCHIVE(a, bodies_, wheels_, steerings_, command_, ground_normal_S_, is_chassis_on_ground_,
               distance_m_, drive_j_, drive_w_, work_, steps_, fault_);
  if (counts() != before) a.refuse("saved state is of another vehicle");
}

bool Vehicle::is_sound() const {
  return (!fault_.empty() || bodies_.is_placed()) && steps_ >= 0 && ground_normal_S_.allFinite();
}

}  // namespace lsos
