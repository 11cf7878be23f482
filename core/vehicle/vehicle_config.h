// What a vehicle is made of: a tree of rigid links joined by springs, steering motors and driven
// wheels. Plain values; suspension templates (wishbone.h) make them from a rover script's numbers.
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
  double preload = 0;                     // N or N m at q = 0; see wishbone.h for who sets it
  double lower_stop = 0, upper_stop = 0;  // m or rad
  double stop_stiffness = 0, stop_damping = 0;
};

struct SteeringMotor {
  double angle_max_rad = 0;  // either way
  double rate_max_radps = 0;
  double torque_max_n_m = 0;
  double stiffness_n_m_prad = 0;  // of the position servo; also holds when parked
  double damping_n_m_sprad = 0;
};

struct DriveMotor {
  double torque_max_n_m = 0;  // at the wheel, after gearing
  double power_max_w = 0;     // mechanical, at the wheel
  // The torque falls linearly to zero at this speed (a DC motor's line); infinite: it does not.
  double no_load_speed_radps = std::numeric_limits<double>::infinity();
  double efficiency = 1;               // mechanical out / electrical in, 0..1
  double servo_gain_n_m_sprad = 0;     // torque a rad/s of speed error
  double servo_integral_n_m_prad = 0;  // torque a rad of accumulated speed error
  double brake_torque_max_n_m = 0;
  double brake_stiffness_n_m_prad = 0;  // of the brake's saved-anchor spring
  double brake_damping_n_m_sprad = 0;
};

struct Wheel {
  double radius_m = 0;  // of the rim, without grousers
  double width_m = 0;
  double normal_stiffness_npm = 0;
  double normal_damping_nspm = 0;
  double tangential_damping_nspm = 0;
  // Of wheel and contact along the ground. Soil that is stiffer than this hardly counts.
  double tangential_stiffness_npm = std::numeric_limits<double>::infinity();
  double grouser_height_m = 0;
  int grouser_count = 0;
  // Friction between rim and soil over friction within the soil, tan(delta)/tan(phi), 0..1. Rough
  // rims and treads shear soil on soil (1).
  double interface_friction_ratio = 0.8;
  double rolling_resistance = 0;  // of the wheel itself (flexing), share of its load

  bool operator==(const Wheel&) const = default;
};

// How a wheel turns: by its motor and brake, freely, or not at all (a seized drive).
enum class WheelMode { driven, free, locked };

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
  // What acts in the joint: one of these at most.
  std::optional<SpringDamper> spring;
  std::optional<SteeringMotor> steering;
  std::optional<DriveMotor> drive;
  std::optional<Wheel> wheel;  // the link is a wheel; its joint axis is the axle
  WheelMode wheel_mode = WheelMode::driven;
  double initial = 0;  // m or rad: where the joint stands when the vehicle is placed
};

// Two joints tied so that one turns as far as the other turns back (a differential): torque on
// both = -stiffness (q1 + q2) - damping (q1' + q2').
struct JointCoupling {
  int first = 0, second = 0;      // links
  double stiffness_n_m_prad = 0;  // > 0
  double damping_n_m_sprad = 0;
};

struct VehicleConfig {
  std::string type;
  Inertia chassis;
  Vec3 p_BC_m = Vec3::Zero();          // chassis' centre of mass
  Vec3 chassis_size_m = Vec3::Zero();  // of its box, for pictures and contact
  double chassis_clearance_m = 0;      // from ground to the box's underside at rest
  std::vector<LinkConfig> links;
  std::vector<JointCoupling> couplings;
  SimTime step{5000};  // divides the exchange period
  double cruise_speed_mps = 0;
  double speed_max_mps = 0;
  double acceleration_mps2 = 0;  // both ways, when following a path
  bool can_turn_on_spot = false;
  bool can_crab = false;  // drives in any direction without turning
  // Wheels that cannot steer slide when the vehicle turns: it turns this much less than their
  // speeds say, as if its track were wider (Mandow et al. 2007). 1: all wheels roll.
  double skid_track_ratio = 1;
  // Electrical drive power is multiplied by this to match field measurements; see the source.
  double drive_calibration = 1;
  std::string drive_calibration_source;
  double turning_radius_min_m = 5;       // while driving
  std::vector<std::string> assumptions;  // sentences for summary.json

  double mass_kg() const;
};

}  // namespace lsos
