#include "vehicle/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "vehicle/plane_fit.h"

namespace lsos {

namespace {

constexpr double settle_limit_s = 20;
constexpr double settled_mps = 1e-4;

bool is_finite(const Vec3& v) { return v.allFinite(); }

}  // namespace

Vehicle::Vehicle(const VehicleConfig& config, const Ground& ground)
    : config_(config),
      ground_(&ground),
      probe_(ground),
      bodies_(config),
      layout_(wheel_layout(config)),
      wheels_(layout_.wheels.size()),
      steerings_(layout_.steerings.size()) {
  for (std::size_t i = 0; i < config_.links.size(); ++i) {
    if (config_.links[i].spring) spring_links_.push_back(static_cast<int>(i));
  }
}

Vec3 Vehicle::reference_point_S_m() const {
  const LinkMotion& chassis = bodies_.motion(Multibody::chassis);
  return chassis.p_C_S_m - chassis.R_SL * config_.p_BC_m;
}

Vec3 Vehicle::reference_velocity_S_mps() const {
  return bodies_.motion(Multibody::chassis).velocity_at(reference_point_S_m());
}

double Vehicle::speed_along_ground_mps() const {
  const Vec3 v_S_mps = reference_velocity_S_mps();
  return (v_S_mps - v_S_mps.dot(ground_normal_S_) * ground_normal_S_).norm();
}

std::string Vehicle::place(const Geodetic& at, double heading_rad) {
  const SiteFrame& site = ground_->site();
  const std::optional<double> elevation_m = ground_->elevation_m(at);
  if (!elevation_m) return "the terrain is not known there";
  const Vec3 p_S_m = site.p_S_m({at.lon_rad, at.lat_rad, *elevation_m});
  const Vec3 up = site.up_S(p_S_m);
  const Vec3 ahead =
      std::cos(heading_rad) * site.north_S(p_S_m) + std::sin(heading_rad) * site.east_S(p_S_m);

  // The plane through the ground under the wheels gives the attitude to begin with.
  std::vector<Vec3> feet_S_m;
  for (const WheelLayout::DrivenWheel& wheel : layout_.wheels) {
    const Vec3 over = p_S_m + wheel.p_B_m.x() * ahead + wheel.p_B_m.y() * up.cross(ahead);
    const GroundSample ground = probe_.sample(over);
    if (!ground.is_ground()) return "the terrain is not known under one of its wheels";
    feet_S_m.push_back(over - ground.gap_m * up);
  }
  const PlaneFit plane = fit_plane(feet_S_m, up);
  Mat3 R_SB;
  R_SB.col(2) = plane.normal;
  R_SB.col(1) = plane.normal.cross(ahead).normalized();
  R_SB.col(0) = R_SB.col(1).cross(R_SB.col(2));
  const double height_m = (plane.point - p_S_m).dot(plane.normal) / up.dot(plane.normal);
  bodies_.place(p_S_m + height_m * up, R_SB);

  command({});
  const double step_s = seconds(config_.step);
  const int steps = static_cast<int>(settle_limit_s / step_s), least = static_cast<int>(1 / step_s);
  bool is_settled = false;
  for (int i = 0; i < steps && !is_settled; ++i) {
    step(step_s);
    is_settled = i >= least && reference_velocity_S_mps().norm() < settled_mps;
  }
  if (!is_settled) {
    return fmt::format("it does not come to rest there: the ground slopes by {:.0f} deg",
                       degrees(std::acos(std::clamp(plane.normal.dot(up), -1.0, 1.0))));
  }
  halt();
  distance_m_ = drive_j_ = drive_w_ = 0;
  return "";
}

void Vehicle::command(const DriveCommand& command) {
  const bool begins_braking = command.is_braking && !command_.is_braking;
  command_ = command;
  if (command.is_braking) {
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
      if (begins_braking)
        wheels_[i].brake_anchor_rad = bodies_.joint_position(layout_.wheels[i].link);
      wheels_[i].spin_target_radps = wheels_[i].servo_integral_rad = 0;
    }
    return;
  }
  std::vector<double> now_rad;
  for (const SteeringState& steering : steerings_) now_rad.push_back(steering.setpoint_rad);
  const WheelTargets targets = wheel_targets(layout_, command, now_rad);
  for (std::size_t i = 0; i < steerings_.size(); ++i) {
    steerings_[i].target_rad = targets.steering_angle_rad[i];
  }
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    wheels_[i].spin_target_radps = targets.spin_radps[i];
  }
}

void Vehicle::advance(SimTime period) {
  const double step_s = seconds(config_.step), before_j = drive_j_;
  for (SimTime t{}; t < period; t += config_.step) step(step_s);
  drive_w_ = (drive_j_ - before_j) / seconds(period);
}

void Vehicle::halt() {
  command_ = {};
  bodies_.halt();
  drive_w_ = 0;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    WheelState& wheel = wheels_[i];
    wheel.brake_anchor_rad = bodies_.joint_position(layout_.wheels[i].link);
    wheel.spin_target_radps = wheel.servo_integral_rad = 0;
    wheel.slip = not_modelled;
  }
}

void Vehicle::step(double step_s) {
  bodies_.add_gravity(ground_->site().gravity_S_mps2(bodies_.motion(Multibody::chassis).p_C_S_m));
  apply_springs();
  apply_steering(step_s);
  drive_j_ += apply_drives(step_s) * step_s;
  apply_contacts(step_s);
  bodies_.step(step_s);

  distance_m_ += speed_along_ground_mps() * step_s;
}

void Vehicle::apply_springs() {
  for (const int link : spring_links_) {
    const SpringDamper& spring = *config_.links[static_cast<std::size_t>(link)].spring;
    const double q = bodies_.joint_position(link), rate = bodies_.joint_velocity(link);
    double force = spring.preload - spring.stiffness * q - spring.damping * rate;
    const double over = q - std::clamp(q, spring.lower_stop, spring.upper_stop);
    if (over != 0) force -= spring.stop_stiffness * over + spring.stop_damping * rate;
    bodies_.add_joint_force(link, force);
  }
}

void Vehicle::apply_steering(double step_s) {
  for (std::size_t i = 0; i < steerings_.size(); ++i) {
    const int link = layout_.steerings[i].link;
    const SteeringMotor& motor = *config_.links[static_cast<std::size_t>(link)].steering;
    SteeringState& state = steerings_[i];
    const double reach_rad = motor.rate_max_radps * step_s;
    state.setpoint_rad += std::clamp(state.target_rad - state.setpoint_rad, -reach_rad, reach_rad);
    const double torque_n_m =
        motor.stiffness_n_m_prad * (state.setpoint_rad - bodies_.joint_position(link)) -
        motor.damping_n_m_sprad * bodies_.joint_velocity(link);
    bodies_.add_joint_force(link,
                            std::clamp(torque_n_m, -motor.torque_max_n_m, motor.torque_max_n_m));
  }
}

double Vehicle::apply_drives(double step_s) {
  double electrical_w = 0;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const int link = layout_.wheels[i].link;
    const DriveMotor& motor = *config_.links[static_cast<std::size_t>(link)].drive;
    WheelState& wheel = wheels_[i];
    const double spin_radps = bodies_.joint_velocity(link);
    if (command_.is_braking) {
      // The brake holds with a spring from where it closed, and slips at its greatest torque.
      const double slack_rad = motor.brake_torque_max_n_m / motor.brake_stiffness_n_m_prad;
      const double angle_rad = bodies_.joint_position(link);
      wheel.brake_anchor_rad =
          std::clamp(wheel.brake_anchor_rad, angle_rad - slack_rad, angle_rad + slack_rad);
      const double torque_n_m =
          motor.brake_stiffness_n_m_prad * (wheel.brake_anchor_rad - angle_rad) -
          motor.brake_damping_n_m_sprad * spin_radps;
      bodies_.add_joint_force(
          link, std::clamp(torque_n_m, -motor.brake_torque_max_n_m, motor.brake_torque_max_n_m));
      continue;
    }
    const double error_radps = wheel.spin_target_radps - spin_radps;
    const double limit_n_m =
        std::min(motor.torque_max_n_m, motor.power_max_w / std::max(std::abs(spin_radps), 1e-6));
    const double integral_rad = wheel.servo_integral_rad + error_radps * step_s;
    const double wanted_n_m =
        motor.servo_gain_n_m_sprad * error_radps + motor.servo_integral_n_m_prad * integral_rad;
    const double torque_n_m = std::clamp(wanted_n_m, -limit_n_m, limit_n_m);
    // At its limit the motor stops accumulating error that it could not act on.
    if (torque_n_m == wanted_n_m) wheel.servo_integral_rad = integral_rad;
    bodies_.add_joint_force(link, torque_n_m);
    electrical_w += std::max(0.0, torque_n_m * spin_radps) / motor.efficiency;
  }
  return electrical_w;
}

void Vehicle::apply_contacts(double step_s) {
  const Soil& soil = ground_->soil();
  Vec3 normals_S = Vec3::Zero();
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const int link = layout_.wheels[i].link;
    const Wheel& shape = *config_.links[static_cast<std::size_t>(link)].wheel;
    WheelState& wheel = wheels_[i];
    const LinkMotion& hub = bodies_.motion(link);
    const Vec3 axle = hub.R_SL.col(1);

    // The rim's lowest point, seen along the ground's normal below the hub; then the ground there.
    GroundSample ground = probe_.sample(hub.p_C_S_m);
    const Vec3 down = -(ground.normal_S - ground.normal_S.dot(axle) * axle).normalized();
    const Vec3 p_contact_S_m = hub.p_C_S_m + shape.radius_m * down;
    ground = probe_.sample(p_contact_S_m);
    wheel.load_n = wheel.sinkage_m = 0;
    wheel.slip = not_modelled;
    if (!ground.is_ground()) continue;
    const Vec3& normal = ground.normal_S;
    normals_S += normal;
    const Vec3 up = ground_->site().up_S(p_contact_S_m);

    WheelContactInput input;
    input.penetration_m = -ground.gap_m * normal.dot(up);
    input.normal_S = normal;
    input.heading_S = axle.cross(normal).normalized();
    input.rim_velocity_S_mps = hub.velocity_at(p_contact_S_m);
    input.hub_velocity_S_mps = hub.v_C_S_mps;
    input.rolling_speed_mps = shape.radius_m * bodies_.joint_velocity(link);
    const WheelContactForces forces = contact_forces(soil, shape, input, step_s, wheel.contact);
    wheel.load_n = forces.load_n;
    wheel.sinkage_m = forces.sinkage_m;
    if (forces.load_n <= 0) continue;
    wheel.slip = slip_ratio(input.hub_velocity_S_mps.dot(input.heading_S), input.rolling_speed_mps);
    bodies_.add_force(link, forces.at_contact_S_n, p_contact_S_m);
    bodies_.add_force(link, forces.at_hub_S_n, hub.p_C_S_m);
  }
  if (normals_S != Vec3::Zero()) ground_normal_S_ = normals_S.normalized();
}

VehicleReport Vehicle::report() {
  const SiteFrame& site = ground_->site();
  VehicleReport report;
  report.p_S_m = reference_point_S_m();
  report.v_S_mps = reference_velocity_S_mps();
  report.is_finite = is_finite(report.p_S_m) && is_finite(report.v_S_mps);
  if (!report.is_finite) return report;
  const Vec3 up = site.up_S(report.p_S_m);
  const Mat3& R_SB = bodies_.motion(Multibody::chassis).R_SL;
  const Vec3 ahead = R_SB.col(0), left = R_SB.col(1);
  const double heading =
      std::atan2(ahead.dot(site.east_S(report.p_S_m)), ahead.dot(site.north_S(report.p_S_m)));
  report.heading_rad = heading < 0 ? heading + 2 * std::numbers::pi : heading;
  if (report.heading_rad >= 2 * std::numbers::pi) report.heading_rad = 0;
  report.pitch_rad = std::asin(std::clamp(ahead.dot(up), -1.0, 1.0));
  // Roll about the nose: right side down lifts the left side.
  report.roll_rad = std::atan2(left.dot(up), R_SB.col(2).dot(up));
  report.yaw_rad = std::atan2(ahead.y(), ahead.x());
  const GroundSample under = probe_.sample(report.p_S_m);
  report.elevation_m = under.elevation_m;
  report.speed_mps = speed_along_ground_mps();

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
    if (std::isnan(wheel.slip)) continue;
    ++slipping;
    slip_sum += wheel.slip;
    if (!(std::abs(report.slip_max) >= std::abs(wheel.slip))) report.slip_max = wheel.slip;
  }
  if (touching > 0) report.sinkage_m = sinkage_sum_m / touching;
  if (slipping > 0) report.slip = slip_sum / slipping;
  if (feet_S_m.size() >= 3) {
    const Vec3 normal_S = fit_plane(feet_S_m, up).normal;
    report.slope_rad = std::atan2(normal_S.cross(up).norm(), normal_S.dot(up));
  }
  return report;
}

std::vector<double> Vehicle::joint_positions() const {
  std::vector<double> positions;
  for (std::size_t i = 0; i < config_.links.size(); ++i) {
    positions.push_back(bodies_.joint_position(static_cast<int>(i)));
  }
  return positions;
}

void Vehicle::archive(Archive& a) {
  a.tag("vehicle")(bodies_)(
      wheels_)(steerings_)(command_)(ground_normal_S_)(distance_m_)(drive_j_)(drive_w_);
}

}  // namespace lsos
