// The components of a vehicle: a tree of rigid links joined by springs, steering motors and driven
// wheels. Plain values; suspension templates (wishbone.h) build them from a rover script's numbers.
//
// Frame B is fixed to the chassis: x forward, y left, z up, origin at the reference point, which
// is the ground centre of the wheelbase with the vehicle at rest on level ground.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/sim_time.h"
#include "base/vector.h"

namespace lsos {

struct Inertia {
  double mass_kg = 0;                // > 0
  Vec3 moments_kgm2 = Vec3::Zero();  // principal, about the centre of mass, > 0
};

// A spring and damper in a joint. Force (or torque) = preload - stiffness q - damping q'. Beyond
// the stops a second, stiffer spring and damper pushes back.
struct SpringDamper {
  double stiffness = 0;                   // N/m or N m/rad
  double damping = 0;                     // N s/m or N m s/rad
  double preload = 0;                     // N or N m at q = 0; set by the template, see wishbone.h
  double lower_stop = 0, upper_stop = 0;  // m or rad
  double stop_stiffness = 0, stop_damping = 0;
};

struct SteeringMotor {
  double angle_max_rad = 0;  // either direction
  double rate_max_radps = 0;
  double torque_max_n_m = 0;
  double stiffness_n_m_prad = 0;  // position servo; also holds while parked
  double damping_n_m_sprad = 0;
};

// Motor of a limb's joint: a position servo behind gears that turns at a limited rate, and a brake
// that holds it while it does not turn.
struct LimbMotor {
  double rate_max_radps = 0;
  double torque_max_n_m = 0;      // at the joint, after gearing
  double stiffness_n_m_prad = 0;  // of servo and gears; also while the brake holds
  double damping_n_m_sprad = 0;
  double brake_torque_max_n_m = 0;
  // Losses while it turns, see drive_power.h; holding takes no power.
  double efficiency = 1;
  double winding_loss_w_pn2m2 = 0;
  double idle_w = 0;

  bool operator==(const LimbMotor&) const = default;
};

// A motor in a joint and the range of the joint's angle.
struct LimbActuator {
  LimbMotor motor;
  double angle_min_rad = 0, angle_max_rad = 0;
};

struct DriveMotor {
  double torque_max_n_m = 0;  // at the wheel, after gearing
  double power_max_w = 0;     // mechanical, at the wheel
  // Speed at which the torque has fallen linearly to zero (a DC motor's line); infinite: it does
  // not fall.
  double no_load_speed_radps = std::numeric_limits<double>::infinity();
  // Losses, see drive_power.h.
  double efficiency = 1;               // of the gears: work at the wheel / work of the motor, 0..1
  double winding_loss_w_pn2m2 = 0;     // W per (N m)^2 of torque at the wheel
  double friction_n_m = 0;             // torque lost whenever it turns
  double idle_w = 0;                   // of the controller while the brake is open
  double servo_gain_n_m_sprad = 0;     // torque per rad/s of speed error
  double servo_integral_n_m_prad = 0;  // torque per rad of accumulated speed error
  double brake_torque_max_n_m = 0;
  double brake_stiffness_n_m_prad = 0;  // spring from the angle at which the brake closed
  double brake_damping_n_m_sprad = 0;

  bool operator==(const DriveMotor&) const = default;
};

struct Wheel {
  double radius_m = 0;  // rim, without grousers
  double width_m = 0;
  double normal_stiffness_npm = 0;
  double normal_damping_nspm = 0;
  double tangential_damping_nspm = 0;
  // Stiffness of wheel and contact along the ground; the softer of this and the soil acts
  // (wheel_soil.h).
  double tangential_stiffness_npm = std::numeric_limits<double>::infinity();
  double grouser_height_m = 0;
  int grouser_count = 0;
  // Friction between rim and soil over friction within the soil, tan(delta)/tan(phi), 0..1. It is 1
  // for rough rims and treads, which shear soil on soil; steel on sand has delta = 2/3 phi
  // (Potyondy 1961), which is 0.6 to 0.65 for sands.
  double interface_friction_ratio = 0.65;
  // Stiffness of the carcass against the load, N/m: the load flattens the wheel by W over it, which
  // lengthens the contact with soil. Infinite: a rigid wheel.
  double carcass_stiffness_npm = std::numeric_limits<double>::infinity();
  double rolling_resistance = 0;  // flexing of the wheel itself, as a share of its load

  bool operator==(const Wheel&) const = default;
};

// How a wheel turns: driven by its motor and brake, freely, or not at all (a seized drive).
enum class WheelMode { driven, free, locked };
constexpr WheelMode last_value(WheelMode) { return WheelMode::locked; }

enum class JointType { revolute, prismatic };

// One link and the joint that ties it to its parent.
struct LinkConfig {
  std::string name;
  int parent = -1;  // index of an earlier link; -1: the chassis
  JointType joint = JointType::revolute;
  Vec3 axis = Vec3::UnitZ();   // unit, in the parent's axes
  Vec3 p_PJ_m = Vec3::Zero();  // joint, in the parent's link frame (chassis: frame B)
  Vec3 p_JC_m = Vec3::Zero();  // the link's centre of mass seen from the joint
  Inertia inertia;
  // Action in the joint: at most one of the four below.
  std::optional<SpringDamper> spring;
  std::optional<SteeringMotor> steering;
  std::optional<LimbActuator> limb;
  std::optional<DriveMotor> drive;
  std::optional<Wheel> wheel;  // the link is a wheel, with its joint axis as axle
  WheelMode wheel_mode = WheelMode::driven;
  double initial = 0;  // position of the joint when the vehicle is placed, m or rad
};

// Two joints tied by a differential so that one turns as far as the other turns back: torque on
// both = -stiffness (q1 + q2) - damping (q1' + q2').
struct JointCoupling {
  int first = 0, second = 0;      // links
  double stiffness_n_m_prad = 0;  // > 0
  double damping_n_m_sprad = 0;
};

// A chain of joints with motors from the chassis to a wheel.
struct LimbConfig {
  std::string name;
  std::vector<int> joints;  // links, from the chassis outwards; a steering joint is none of them
  int wheel = 0;            // link
};

// Gains of active posture control, see posture_control.h.
struct PostureGains {
  double leveling_1ps = 0;         // rate at which the chassis levels, for each radian of tilt
  double load_sharing_mps_pn = 0;  // rate at which a limb yields, for each newton of excess load
};

// A way of standing on limbs: where the wheels are under the chassis.
struct LimbStance {
  std::string name;
  std::vector<Vec3> hubs_B_m;  // by limb
  bool is_level = true;        // chassis level; false: parallel to the ground
};

struct VehicleConfig {
  std::string type;
  Inertia chassis;
  Vec3 p_BC_m = Vec3::Zero();          // centre of mass of the chassis
  Vec3 chassis_size_m = Vec3::Zero();  // size of its box, for pictures and contact
  double chassis_clearance_m = 0;      // from ground to the box's underside at rest
  std::vector<LinkConfig> links;
  std::vector<JointCoupling> couplings;
  std::vector<LimbConfig> limbs;
  std::optional<PostureGains> posture;  // absent: limbs hold their stance whatever the ground
  std::vector<LimbStance> stances;      // those of the rover's configurations
  bool starts_level = true;             // the stance that it starts in
  SimTime step{5000};                   // divides the exchange period
  double cruise_speed_mps = 0;
  double speed_max_mps = 0;
  double acceleration_mps2 = 0;  // speeding up and slowing down on a path
  bool can_turn_on_spot = false;
  bool can_crab = false;  // can drive in any direction without turning
  // Wheels that cannot steer slide when the vehicle turns. It then turns more slowly than the wheel
  // speeds imply, as if its track were wider by this ratio (Mandow et al. 2007). 1: all wheels
  // roll.
  double skid_track_ratio = 1;
  // Factor on the electrical drive power that matches field measurements; see the source.
  double drive_calibration = 1;
  std::string drive_calibration_source;
  double turning_radius_min_m = 5;       // while driving
  std::vector<std::string> assumptions;  // sentences for summary.json

  double mass_kg() const;
};

}  // namespace lsos
