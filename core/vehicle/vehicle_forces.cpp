// Forces on a vehicle in one step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "vehicle/drive_power.h"
#include "vehicle/vehicle.h"

namespace lsos {

namespace {

// Contact of the chassis: it sinks this far into the ground under the vehicle's whole weight, and
// slides with this friction. Both are assumptions; a contact fails the drive in any case.
constexpr double chassis_sag_m = 0.02;
constexpr double chassis_friction = 0.5;
constexpr double chassis_slide_mps = 0.01;  // friction is proportional to speed below this
// The contact is computed in each step when the chassis is nearer to the ground than this, plus the
// distance by which it can approach within a period over a slope of 1:2.
constexpr double chassis_near_m = 0.02;
constexpr double chassis_approach = 0.5;

// Time constant with which the contact point of a wheel moves along its rim. Applied at once, the
// normal of the ground found there would make it jump back and forth for ever on ground of more
// curvature than the wheel.
constexpr double search_smoothing_s = 0.02;

// Travel, as a share of the wheel's radius, for which a contact plane serves. It is less than the
// length of the contact.
constexpr double contact_plane_radii = 1.0 / 12;

constexpr double limit_smoothing_s = 0.2;  // for the speed at which a motor's limits are evaluated

}  // namespace

void Vehicle::step(double step_s) {
  bodies_.add_gravity(gravity_S_mps2_);
  apply_springs(step_s);
  apply_steering(step_s);
  drive_j_ += config_.drive_calibration * apply_drives(step_s) * step_s;
  if (posture_) drive_j_ += apply_limbs(step_s) * step_s;
  apply_contacts(step_s);
  if (is_chassis_near_ground_) apply_chassis_contact(step_s);
  bodies_.step(step_s);
  ++steps_;

  const double speed_mps = speed_along_ground_mps();
  if (!std::isfinite(speed_mps)) {
    find_fault();
    return;
  }
  distance_m_ += speed_mps * step_s;
}

void Vehicle::find_fault() {
  const std::optional<int> link = bodies_.non_finite_link();
  const std::string part = !link || *link == Multibody::chassis
                               ? "its chassis"
                               : config_.links[static_cast<std::size_t>(*link)].name;
  fault_ = fmt::format(
      "its dynamics gave a number that is not finite in step {} after it was placed, first in the "
      "motion of {}",
      steps_, part);
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelState& wheel = wheels_[i];
    if (std::isfinite(wheel.load_n + wheel.torque_n_m)) continue;
    fault_ += fmt::format("; {} had a load of {} N and a torque of {} N m",
                          config_.links[static_cast<std::size_t>(parts_[i].link)].name,
                          wheel.load_n, wheel.torque_n_m);
    break;
  }
}

void Vehicle::apply_springs(double step_s) {
  for (const int link : spring_links_) {
    const SpringDamper& spring = *config_.links[static_cast<std::size_t>(link)].spring;
    const double q = bodies_.joint_position(link), rate = bodies_.joint_velocity(link);
    double force = spring.preload - spring.stiffness * q - spring.damping * rate;
    const double over = q - std::clamp(q, spring.lower_stop, spring.upper_stop);
    if (over != 0) force -= spring.stop_stiffness * over + spring.stop_damping * rate;
    bodies_.add_joint_force(link, force);
    work_.suspension_j += force * rate * step_s;
  }
  for (const JointCoupling& coupling : config_.couplings) {
    const double q =
        bodies_.joint_position(coupling.first) + bodies_.joint_position(coupling.second);
    const double rate =
        bodies_.joint_velocity(coupling.first) + bodies_.joint_velocity(coupling.second);
    const double torque_n_m = -coupling.stiffness_n_m_prad * q - coupling.damping_n_m_sprad * rate;
    bodies_.add_joint_force(coupling.first, torque_n_m);
    bodies_.add_joint_force(coupling.second, torque_n_m);
    work_.suspension_j += torque_n_m * rate * step_s;
  }
}

void Vehicle::apply_steering(double step_s) {
  for (std::size_t i = 0; i < steerings_.size(); ++i) {
    const int link = layout_.steerings[i].link;
    const SteeringMotor& motor = *config_.links[static_cast<std::size_t>(link)].steering;
    SteeringState& state = steerings_[i];
    const double reach_rad = motor.rate_max_radps * step_s;
    state.setpoint_rad += std::clamp(state.target_rad - state.setpoint_rad, -reach_rad, reach_rad);
    const double rate = bodies_.joint_velocity(link);
    const double torque_n_m =
        std::clamp(motor.stiffness_n_m_prad * (state.setpoint_rad - bodies_.joint_position(link)) -
                       motor.damping_n_m_sprad * rate,
                   -motor.torque_max_n_m, motor.torque_max_n_m);
    bodies_.add_joint_force(link, torque_n_m);
    work_.steering_j += torque_n_m * rate * step_s;
  }
}

// The brake is a spring from the angle at which it closed, and slips at its greatest torque.
double Vehicle::brake_torque_n_m(const DriveMotor& motor, double angle_rad, double spin_radps,
                                 WheelState& wheel) const {
  const double slack_rad = motor.brake_torque_max_n_m / motor.brake_stiffness_n_m_prad;
  wheel.brake_anchor_rad =
      std::clamp(wheel.brake_anchor_rad, angle_rad - slack_rad, angle_rad + slack_rad);
  const double torque_n_m = motor.brake_stiffness_n_m_prad * (wheel.brake_anchor_rad - angle_rad) -
                            motor.brake_damping_n_m_sprad * spin_radps;
  return std::clamp(torque_n_m, -motor.brake_torque_max_n_m, motor.brake_torque_max_n_m);
}

// Speed servo within the limits of the motor: torque, power, and the line from stall to no load in
// the direction in which it turns. The brake supplies the holding torque that the motor lacks.
double Vehicle::motor_torque_n_m(const DriveMotor& motor, double spin_radps, double step_s,
                                 WheelState& wheel) const {
  // The line is steeper than the servo's gain: evaluated at the present speed it would shake a
  // light wheel. It is evaluated at a filtered speed; deviations from that are damped with the
  // servo's gain.
  wheel.smooth_spin_radps +=
      (spin_radps - wheel.smooth_spin_radps) * std::min(1.0, step_s / limit_smoothing_s);
  const double smooth_radps = wheel.smooth_spin_radps, speed_radps = std::abs(smooth_radps);
  const double error_radps = wheel.spin_target_radps - spin_radps;
  const double most_n_m =
      std::min(motor.torque_max_n_m, motor.power_max_w / std::max(speed_radps, 1e-6));
  const double driving_n_m = std::clamp(
      motor.torque_max_n_m * (1 - speed_radps / motor.no_load_speed_radps), 0.0, most_n_m);
  const double integral_rad = wheel.servo_integral_rad + error_radps * step_s;
  const double wanted_n_m =
      motor.servo_gain_n_m_sprad * error_radps + motor.servo_integral_n_m_prad * integral_rad;
  const double holding_n_m = most_n_m + motor.brake_torque_max_n_m;
  const double low_n_m = smooth_radps < 0 ? -driving_n_m : -holding_n_m;
  const double high_n_m = smooth_radps > 0 ? driving_n_m : holding_n_m;
  double torque_n_m = std::clamp(wanted_n_m, low_n_m, high_n_m);
  // Anti-windup: at its limit the motor accumulates only errors that reduce the excess.
  if (torque_n_m == wanted_n_m || (wanted_n_m - torque_n_m) * error_radps < 0) {
    wheel.servo_integral_rad = integral_rad;
  }
  if (torque_n_m != wanted_n_m) {
    torque_n_m = std::clamp(torque_n_m + motor.servo_gain_n_m_sprad * (smooth_radps - spin_radps),
                            std::min(-motor.torque_max_n_m, low_n_m),
                            std::max(motor.torque_max_n_m, high_n_m));
  }
  return torque_n_m;
}

double Vehicle::apply_drives(double step_s) {
  double electrical_w = 0;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelPart& part = parts_[i];
    WheelState& wheel = wheels_[i];
    if (part.motor == nullptr || wheel.mode == WheelMode::free) continue;
    const double spin_radps = bodies_.joint_velocity(part.link);
    if (command_.is_braking || wheel.mode == WheelMode::locked) {
      wheel.torque_n_m =
          brake_torque_n_m(*part.motor, bodies_.joint_position(part.link), spin_radps, wheel);
      work_.brakes_j += wheel.torque_n_m * spin_radps * step_s;
    } else {
      wheel.torque_n_m = motor_torque_n_m(*part.motor, spin_radps, step_s, wheel);
      const double motor_n_m =
          std::clamp(wheel.torque_n_m, -part.motor->torque_max_n_m, part.motor->torque_max_n_m);
      work_.motors_j += motor_n_m * spin_radps * step_s;
      work_.brakes_j += (wheel.torque_n_m - motor_n_m) * spin_radps * step_s;
      electrical_w += drive_power_w(*part.motor, motor_n_m, spin_radps);
    }
    bodies_.add_joint_force(part.link, wheel.torque_n_m);
  }
  return electrical_w;
}

const Vehicle::ContactPlane& Vehicle::contact_plane(std::size_t wheel, const Vec3& rim_S_m) {
  ContactPlane& contact_plane = contact_planes_[wheel];
  const double reach_m = contact_plane_radii * parts_[wheel].shape->radius_m;
  const bool is_near = (rim_S_m - contact_plane.p_S_m).squaredNorm() <= reach_m * reach_m;
  if (contact_plane.steps_left > 0 && is_near && !command_.is_braking) {
    --contact_plane.steps_left;
    return contact_plane;
  }
  const GroundSample ground = probe_.sample(rim_S_m);
  contact_plane = {contact_plane_steps_, rim_S_m, ground.gap_m * ground.normal_S.dot(ground.up_S),
                   ground.normal_S, ground.soil};
  return contact_plane;
}

void Vehicle::apply_contacts(double step_s) {
  const double search_share = std::min(1.0, step_s / search_smoothing_s);
  Vec3 normals_S = Vec3::Zero();
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelPart& part = parts_[i];
    WheelState& wheel = wheels_[i];
    const LinkMotion& hub = bodies_.motion(part.link);
    const Vec3 axle = hub.R_SL.col(1);

    // The rim's lowest point along the last search normal, and the ground there.
    const Vec3& search_S = wheel.search_S;
    const Vec3 down = -(search_S - search_S.dot(axle) * axle).normalized();
    const Vec3 arm_m = part.shape->radius_m * down;
    const Vec3 rim_S_m = hub.p_C_S_m + arm_m;
    const ContactPlane& ground = contact_plane(i, rim_S_m);
    wheel.load_n = wheel.sinkage_m = 0;
    wheel.slip = not_modelled;
    if (std::isnan(ground.gap_m)) continue;
    const Vec3& normal = ground.normal_S;
    wheel.search_S += search_share * (normal - search_S);
    normals_S += normal;

    const Vec3 v_contact_mps = hub.v_C_S_mps + hub.omega_S_radps.cross(arm_m);
    WheelContactInput input;
    const double gap_m = ground.gap_m + normal.dot(rim_S_m - ground.p_S_m);
    input.load_n = normal_load_n(*part.shape, -gap_m, -v_contact_mps.dot(normal));
    input.normal_S = normal;
    input.heading_S = axle.cross(normal).normalized();
    input.hub_velocity_S_mps = hub.v_C_S_mps - hub.v_C_S_mps.dot(normal) * normal;
    const auto soil = static_cast<std::size_t>(ground.soil);
    const WheelSoil& on_soil = part.soils[soil];
    const double spin_radps = bodies_.joint_velocity(part.link);
    input.rim_speed_mps = on_soil.shear_radius_m() * spin_radps;
    const WheelContactForces forces = on_soil.forces(input, step_s, wheel.contact);
    if (input.load_n <= 0) continue;
    wheel.load_n = input.load_n;
    wheel.sinkage_m = forces.sinkage_m;
    wheel.slip =
        slip_ratio(hub.v_C_S_mps.dot(input.heading_S), part.rolling_radii_m[soil] * spin_radps);

    const Vec3 force_n = input.load_n * normal + forces.traction_S_n + forces.hub_force_S_n;
    const Vec3 torque_n_m = down.cross(forces.arm_m * forces.traction_S_n +
                                       part.shape->radius_m * input.load_n * normal);
    bodies_.add_wrench(part.link, force_n, torque_n_m);
    work_.soil_j += (force_n.dot(hub.v_C_S_mps) + torque_n_m.dot(hub.omega_S_radps)) * step_s;
  }
  if (normals_S != Vec3::Zero()) ground_normal_S_ = normals_S.normalized();
}

void Vehicle::update_chassis_near_ground() {
  const LinkMotion& chassis = bodies_.motion(Multibody::chassis);
  double speed_mps =
      chassis.v_C_S_mps.norm() + chassis.omega_S_radps.norm() * config_.chassis_size_m.norm() / 2;
  const double near_m = chassis_near_m + chassis_approach * speed_mps * seconds(exchange_period);
  const double sunk_m = mean_sinkage_m();
  is_chassis_near_ground_ = false;
  for (const Vec3& p_B_m : underside_B_m_) {
    const GroundSample ground =
        probe_.sample(chassis.p_C_S_m + chassis.R_SL * (p_B_m - config_.p_BC_m));
    if (ground.is_ground() && ground.gap_m < near_m + sunk_m) is_chassis_near_ground_ = true;
  }
}

// Mean sinkage of the wheels in contact: it lowers the chassis towards the ground between them.
double Vehicle::mean_sinkage_m() const {
  double sum_m = 0, touching = 0;
  for (const WheelState& wheel : wheels_) {
    sum_m += wheel.sinkage_m;
    if (wheel.load_n > 0) ++touching;
  }
  return touching > 0 ? sum_m / touching : 0;
}

void Vehicle::apply_chassis_contact(double step_s) {
  const double sunk_m = mean_sinkage_m();
  const double mass_kg = config_.mass_kg();
  const LinkMotion& chassis = bodies_.motion(Multibody::chassis);
  // The points of about one edge carry the whole load.
  const double carrying = std::sqrt(static_cast<double>(underside_B_m_.size()));
  const double stiffness_npm = mass_kg * gravity_S_mps2_.norm() / (chassis_sag_m * carrying);
  const double damping_nspm = std::sqrt(stiffness_npm * mass_kg) / 2;
  // Friction must not reverse the motion within a step.
  const double drag_max_nspm = mass_kg / (4 * static_cast<double>(underside_B_m_.size()) * step_s);
  for (const Vec3& p_B_m : underside_B_m_) {
    const Vec3 p_S_m = chassis.p_C_S_m + chassis.R_SL * (p_B_m - config_.p_BC_m);
    const GroundSample ground = probe_.sample(p_S_m);
    if (!ground.is_ground()) continue;
    const double deep_m = (sunk_m - ground.gap_m) * ground.normal_S.dot(ground.up_S);
    if (deep_m <= 0) continue;
    is_chassis_on_ground_ = true;
    const Vec3 v_mps = chassis.velocity_at(p_S_m);
    const double out_mps = v_mps.dot(ground.normal_S);
    const double load_n = std::max(0.0, stiffness_npm * deep_m - damping_nspm * out_mps);
    const Vec3 slide_mps = v_mps - out_mps * ground.normal_S;
    const double drag_nspm = std::min(
        chassis_friction * load_n / std::max(slide_mps.norm(), chassis_slide_mps), drag_max_nspm);
    const Vec3 force_n = load_n * ground.normal_S - drag_nspm * slide_mps;
    bodies_.add_force(Multibody::chassis, force_n, p_S_m);
    work_.chassis_j += force_n.dot(v_mps) * step_s;
  }
}

}  // namespace lsos
