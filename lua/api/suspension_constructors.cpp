// lsos.wishbone, lsos.rocker_bogie, lsos.skid_steer, lsos.legged and their parts.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "lua/api/constructors.h"
#include "lua/api/rover_constructors.h"
#include "vehicle/suspension/rover_spec.h"

namespace lsos {

namespace {

// Value of lsos.wheel: the properties of one wheel.
struct WheelScript {
  Wheel wheel;
  double mass_kg = 0;
  std::optional<Vec3> moments_kgm2;
};

struct Spring {
  double stiffness_npm = 0, damping_nspm = 0;
  double travel_up_m = 0, travel_down_m = 0;
};

// Reads a wheel's place on the ground at rest.
void read_place(TableReader& t, Vec2& p_B_m, const char* doc) {
  Vec3 position_m = Vec3::Zero();
  t.vec3(required, "position_m", position_m, doc);
  if (position_m.z() != 0) t.fault("position_m: z must be 0, the wheels stand on the ground");
  p_B_m = position_m.head<2>();
}

void read_module(TableReader& t, WishboneModule& module) {
  t.text(required, "name", module.name, "As in the log: 'front_left'.");
  read_place(t, module.p_B_m, "Of the steering axis: forward, left; z is 0.");
  t.boolean(optional, "is_steered", module.is_steered,
            "Default true; without, it has no knuckle and no knuckle's mass.");
}

void read_wheel(TableReader& t, WheelScript& script) {
  Wheel& wheel = script.wheel;
  std::int64_t grouser_count = 0;
  t.number(required, "radius_m", wheel.radius_m, {0, 10, true}, "Of the rim, without grousers.");
  t.number(required, "width_m", wheel.width_m, {0, 10, true}, "Of the tread.");
  t.number(required, "mass_kg", script.mass_kg, positive, "Of one wheel.");
  read_moments(t, MomentsOf::wheel, script.moments_kgm2,
               "Principal moments: forward, axle, up; about the axle with what the drive turns "
               "behind its gear (default: of a solid disc).");
  t.number(required, "normal_stiffness_npm", wheel.normal_stiffness_npm, positive,
           "Of wheel and ground, along the ground's normal.");
  t.number(required, "normal_damping_nspm", wheel.normal_damping_nspm, not_negative,
           "Along the ground's normal.");
  wheel.tangential_stiffness_npm = wheel.normal_stiffness_npm;
  t.number(optional, "tangential_stiffness_npm", wheel.tangential_stiffness_npm, positive,
           "Of wheel and ground, along the ground (default: as along the normal).");
  t.number(required, "tangential_damping_nspm", wheel.tangential_damping_nspm, not_negative,
           "Along the ground.");
  t.number(optional, "grouser_height_m", wheel.grouser_height_m, not_negative,
           "From the rim (default 0: smooth).");
  t.integer(optional, "grouser_count", grouser_count, {0, 1000}, "Round the rim (default 0).");
  t.number(optional, "interface_friction_ratio", wheel.interface_friction_ratio, {0, 1, true},
           "Friction of rim on soil over friction within the soil; rough rims and treads have 1 "
           "(default 0.65: bare metal on sand).");
  t.number(optional, "carcass_stiffness_npm", wheel.carcass_stiffness_npm, positive,
           "How much load flattens the wheel by a metre: mesh and tyres lie on soil with a longer "
           "contact (default: a rigid wheel).");
  t.number(optional, "rolling_resistance", wheel.rolling_resistance, fraction,
           "Of the wheel itself, a share of its load (default 0).");
  wheel.grouser_count = static_cast<int>(grouser_count);
}

void read_spring(TableReader& t, Spring& spring) {
  t.number(required, "stiffness_npm", spring.stiffness_npm, positive, "At the wheel module.");
  t.number(required, "damping_nspm", spring.damping_nspm, not_negative, "At the wheel module.");
  t.number(required, "travel_up_m", spring.travel_up_m, positive,
           "Compression from rest to the stop.");
  t.number(required, "travel_down_m", spring.travel_down_m, positive,
           "Droop from rest to the stop.");
}

void read_steering(TableReader& t, SteeringMotor& motor) {
  t.number(required, "angle_max_rad", motor.angle_max_rad, {0, std::numbers::pi}, "Either way.");
  t.number(required, "rate_max_radps", motor.rate_max_radps, positive, "Turning rate.");
  t.number(required, "torque_max_n_m", motor.torque_max_n_m, positive, "Of the motor.");
  t.number(required, "stiffness_n_m_prad", motor.stiffness_n_m_prad, positive,
           "Of the position servo; holds when parked.");
  t.number(required, "damping_n_m_sprad", motor.damping_n_m_sprad, not_negative,
           "Of the position servo.");
}

void read_drive(TableReader& t, DriveMotor& motor) {
  t.number(required, "torque_max_n_m", motor.torque_max_n_m, positive, "At the wheel.");
  t.number(required, "power_max_w", motor.power_max_w, positive, "Mechanical, at the wheel.");
  t.number(optional, "no_load_speed_radps", motor.no_load_speed_radps, positive,
           "Of the wheel: the motor's torque falls linearly to nothing there (default: it does "
           "not).");
  t.number(
      required, "efficiency", motor.efficiency, {0, 1, true},
      "Of the gears: work at the wheel over work of the motor. Without the losses that follow, "
      "mechanical out over electrical in.");
  t.number(
      optional, "winding_loss_w_pn2m2", motor.winding_loss_w_pn2m2, not_negative,
      "Electrical loss of the motor per torque at the wheel squared: R / (i k_t)^2 for windings "
      "of R ohm, a torque constant k_t and a gear ratio i (default 0).");
  t.number(optional, "friction_n_m", motor.friction_n_m, not_negative,
           "Torque at the wheel that bearings, seals and gears take whenever it turns, as "
           "electrical loss (default 0).");
  t.number(optional, "idle_w", motor.idle_w, not_negative,
           "Power of the motor's controller while the brake is open, driving or braking "
           "(default 0).");
  t.number(required, "servo_gain_n_m_sprad", motor.servo_gain_n_m_sprad, positive,
           "Torque per speed error.");
  t.number(required, "servo_integral_n_m_prad", motor.servo_integral_n_m_prad, not_negative,
           "Torque per accumulated speed error.");
  t.number(required, "brake_torque_max_n_m", motor.brake_torque_max_n_m, positive,
           "Of the brake, at the wheel.");
  t.number(required, "brake_stiffness_n_m_prad", motor.brake_stiffness_n_m_prad, positive,
           "Of the brake's hold.");
  t.number(required, "brake_damping_n_m_sprad", motor.brake_damping_n_m_sprad, not_negative,
           "Of the brake's hold.");
}

// Reads the wheels and motors of any suspension.
template <class Suspension>
void read_wheels(TableReader& t, Suspension& suspension) {
  WheelScript wheel;
  t.made(required, "wheel", "wheel", wheel, "Every wheel.");
  t.made(required, "drive", "drive", suspension.drive, "The motor of every wheel.");
  suspension.wheel = wheel.wheel;
  suspension.wheel_mass_kg = wheel.mass_kg;
  suspension.wheel_moments_kgm2 = wheel.moments_kgm2;
}

// Reads the knuckles and steering of a suspension that has them; required when something is
// steered.
template <class Suspension>
void read_knuckles(TableReader& t, Suspension& suspension, bool is_steered, const char* of) {
  std::optional<double> knuckle_mass_kg;
  t.number(optional, "knuckle_mass_kg", knuckle_mass_kg, positive,
           "Of one: what is steered, without wheels; needed when any is steered.");
  t.made(optional, "steering", "steering", suspension.steering,
         "Of each that is steered; needed when any is.");
  suspension.knuckle_mass_kg = knuckle_mass_kg.value_or(0);
  if (t.L() == nullptr || !is_steered) return;
  const auto need = [&](const char* key, bool is_given) {
    if (!is_given) t.fault(fmt::format("'{}' is missing: {} is steered", key, of));
  };
  need("knuckle_mass_kg", knuckle_mass_kg.has_value());
  need("steering", suspension.steering.stiffness_n_m_prad > 0);
}

void read_wishbone(TableReader& t, Wishbone& wishbone) {
  Spring spring;
  t.list(required, "modules", "module", wishbone.modules, "Where wheel modules are.");
  t.number(required, "arm_mass_kg", wishbone.arm_mass_kg, positive,
           "Of one module: moves with the spring, is not steered.");
  read_knuckles(t, wishbone, std::ranges::any_of(wishbone.modules, &WishboneModule::is_steered),
                "a module");
  t.made(required, "spring", "spring", spring, "Of one module.");
  t.numbers(required, "wheel_offsets_m", wishbone.wheel_offsets_m, any_number,
            "Of a module's wheels along the axle from the steering axis, left positive.");
  read_wheels(t, wishbone);
  wishbone.stiffness_npm = spring.stiffness_npm;
  wishbone.damping_nspm = spring.damping_nspm;
  wishbone.travel_up_m = spring.travel_up_m;
  wishbone.travel_down_m = spring.travel_down_m;
}

void read_station(TableReader& t, WheelStation& station) {
  std::string arm = "rocker";
  t.text(required, "name", station.name,
         "'front': its wheels are front_left_wheel and front_right_wheel.");
  read_place(t, station.p_B_m,
             "Of the left wheel: forward, left; z is 0. The right one mirrors it.");
  t.boolean(optional, "is_steered", station.is_steered,
            "Default false; without, it has no knuckle and no knuckle's mass.");
  t.boolean(optional, "is_driven", station.is_driven,
            "Default true; without, its wheels turn freely.");
  t.text(optional, "on", arm, "'rocker' (default) or 'bogie': what carries it.");
  if (arm != "rocker" && arm != "bogie") {
    t.fault(fmt::format("on = '{}': must be 'rocker' or 'bogie'", arm));
  }
  station.arm = arm == "bogie" ? Arm::bogie : Arm::rocker;
}

void read_swing_arm(TableReader& t, SwingArm& arm) {
  t.vec3(required, "pivot_m", arm.p_B_pivot_m,
         "Of the left one at rest: forward, left, up. The right one mirrors it.");
  t.number(required, "mass_kg", arm.mass_kg, positive, "Of one, without knuckles and wheels.");
  t.vec3(optional, "center_of_mass_m", arm.p_B_center_m,
         "Of the left one at rest: forward, left, up (default: the middle of what it joins).");
  read_moments(t, MomentsOf::body, arm.moments_kgm2,
               "Principal moments about its centre of mass (default: of a box round what it "
               "joins).");
  t.number(required, "angle_max_rad", arm.angle_max_rad, {0, 1.5, true},
           "Either way from rest to its stop.");
  t.number(required, "stop_stiffness_n_m_prad", arm.stop_stiffness_n_m_prad, positive,
           "Of the stop.");
  t.number(required, "stop_damping_n_m_sprad", arm.stop_damping_n_m_sprad, not_negative,
           "Of the stop.");
  t.number(optional, "damping_n_m_sprad", arm.damping_n_m_sprad, not_negative,
           "Of the bearing (default 0).");
}

void read_differential(TableReader& t, Differential& differential) {
  std::string kind;
  t.text(required, "kind", kind, "'bar' across the body or 'gear' on the rockers' shafts.");
  t.vec3(required, "position_m", differential.p_B_m,
         "Of its centre of mass: forward, left, up as for the chassis.");
  t.number(required, "mass_kg", differential.mass_kg, positive,
           "Moves with the chassis, besides its mass.");
  t.number(required, "stiffness_n_m_prad", differential.stiffness_n_m_prad, positive,
           "Against the rockers turning the same way on the chassis.");
  t.number(required, "damping_n_m_sprad", differential.damping_n_m_sprad, not_negative,
           "Of the same.");
  if (!kind.empty() && kind != "bar" && kind != "gear") {
    t.fault(fmt::format("kind = '{}': must be 'bar' or 'gear'", kind));
  }
  differential.kind = kind == "gear" ? Differential::Kind::gear : Differential::Kind::bar;
}

void read_rocker_bogie(TableReader& t, RockerBogie& suspension) {
  t.list(required, "stations", "station", suspension.stations, "Where wheels are.");
  t.made(required, "rocker", "rocker", suspension.rocker, "Of each side.");
  SwingArm bogie;
  t.made(optional, "bogie", "bogie", bogie, "On each rocker (default: none).");
  if (bogie.mass_kg > 0) suspension.bogie = bogie;
  t.made(required, "differential", "differential", suspension.differential, "Ties the rockers.");
  read_knuckles(t, suspension, std::ranges::any_of(suspension.stations, &WheelStation::is_steered),
                "a station");
  read_wheels(t, suspension);
}

void read_skid_steer(TableReader& t, SkidSteer& suspension) {
  SwingArm rocker;
  Differential differential;
  t.list(required, "stations", "station", suspension.stations, "Where wheels are.");
  t.made(optional, "rocker", "rocker", rocker, "Of each side (default: wheels on the chassis).");
  t.made(optional, "differential", "differential", differential,
         "Ties the rockers; needed with them.");
  if (rocker.mass_kg > 0) suspension.rocker = rocker;
  if (differential.mass_kg > 0) suspension.differential = differential;
  t.number(required, "turning_track_ratio", suspension.turning_track_ratio, {1},
           "It turns this much less than the speeds of its sides say, as its wheels slide.");
  read_wheels(t, suspension);
}

void read_limb_motor(TableReader& t, LimbMotor& motor) {
  t.number(required, "rate_max_radps", motor.rate_max_radps, positive, "Turning rate.");
  t.number(required, "torque_max_n_m", motor.torque_max_n_m, positive, "At the joint.");
  t.number(required, "stiffness_n_m_prad", motor.stiffness_n_m_prad, positive,
           "Of position servo and gears, also while the brake holds.");
  t.number(required, "damping_n_m_sprad", motor.damping_n_m_sprad, not_negative, "Of the same.");
  t.number(required, "brake_torque_max_n_m", motor.brake_torque_max_n_m, positive,
           "Of the brake, which holds a joint that is not to turn.");
  t.number(required, "efficiency", motor.efficiency, {0, 1, true},
           "Of the gears: work at the joint over work of the motor.");
  t.number(optional, "winding_loss_w_pn2m2", motor.winding_loss_w_pn2m2, not_negative,
           "Electrical loss per torque at the joint squared, while it turns (default 0).");
  t.number(optional, "idle_w", motor.idle_w, not_negative,
           "Power of its controller while it turns (default 0).");
}

void read_joint(TableReader& t, LimbJoint& joint) {
  t.text(required, "name", joint.name, "'knee': with its limb's name before it in the log.");
  t.vec3(required, "position_m", joint.p_B_m, "At rest: forward, left, up as for the chassis.");
  t.vec3(required, "axis", joint.axis_B,
         "About which it turns, at rest; its length is of no matter.");
  t.made(required, "motor", "limb_motor", joint.actuator.motor, "Turns and holds it.");
  t.number(required, "angle_min_rad", joint.actuator.angle_min_rad, {-7, 0},
           "End of its range, counted from rest.");
  t.number(required, "angle_max_rad", joint.actuator.angle_max_rad, {0, 7}, "The other end.");
  t.number(required, "mass_kg", joint.mass_kg, positive,
           "Of the segment from this joint to the next.");
  t.vec3(optional, "center_of_mass_m", joint.p_B_center_m,
         "Of the segment at rest (default: the middle between both joints).");
  read_moments(
      t, MomentsOf::body, joint.moments_kgm2,
      "Principal moments of the segment about its centre of mass, forward, left, up at rest "
      "(default: of a rod between both joints).");
  if (t.L() == nullptr) return;
  if (joint.axis_B.norm() == 0) t.fault("axis: (0, 0, 0) is no direction");
  joint.axis_B.normalize();
  if (joint.actuator.angle_min_rad == joint.actuator.angle_max_rad) {
    t.fault("angle_min_rad and angle_max_rad are both 0: a joint must have a range to turn in");
  }
}

void read_limb(TableReader& t, Limb& limb) {
  t.text(required, "name", limb.name, "'limb_1': its parts in the log begin with it.");
  read_place(t, limb.p_B_wheel_m, "Of its wheel: forward, left; z is 0.");
  t.list(required, "joints", "joint", limb.joints, "From the chassis outwards.");
  t.boolean(optional, "is_steered", limb.is_steered,
            "Whether its wheel turns on a knuckle about the vertical, after the joints (default "
            "true).");
}

void read_posture(TableReader& t, PostureGains& gains) {
  t.number(required, "leveling_1ps", gains.leveling_1ps, {0, 10, true},
           "How fast the chassis levels, for each radian that it is tilted.");
  t.number(required, "load_sharing_mps_pn", gains.load_sharing_mps_pn, not_negative,
           "How fast a limb yields, for each newton that its wheel carries too much.");
}

void read_legged(TableReader& t, Legged& suspension) {
  PostureGains gains;
  t.list(required, "limbs", "limb", suspension.limbs, "Where limbs are.");
  t.made(optional, "posture", "posture", gains,
         "Active control of its posture (default: limbs hold their stance on any ground).");
  if (gains.leveling_1ps > 0) suspension.posture = gains;
  read_knuckles(t, suspension, std::ranges::any_of(suspension.limbs, &Limb::is_steered), "a limb");
  read_wheels(t, suspension);
}

}  // namespace

std::vector<Constructor> suspension_constructors() {
  return {
      constructor<Wishbone, read_wishbone>(
          "wishbone", "Suspension: independently sprung wheel modules, each with its wheels."),
      constructor<WishboneModule, read_module>("module", "One wheel module's place."),
      constructor<Spring, read_spring>("spring", "Spring and damper of a wheel module."),
      constructor<RockerBogie, read_rocker_bogie>(
          "rocker_bogie",
          "Suspension: rockers tied by a differential, with or without bogies on them."),
      constructor<SkidSteer, read_skid_steer>(
          "skid_steer",
          "Suspension: wheels that do not steer, on the chassis or on rockers; it turns by "
          "sliding."),
      constructor<WheelStation, read_station>(
          "station", "A wheel on the left and one on the right of the last two suspensions."),
      constructor<Legged, read_legged>(
          "legged", "Suspension: wheels on limbs, which are chains of joints with motors."),
      constructor<Limb, read_limb>("limb", "A limb and its wheel."),
      constructor<LimbJoint, read_joint>("joint", "A joint of a limb, and what it moves."),
      constructor<LimbMotor, read_limb_motor>("limb_motor", "Servo and brake of a limb's joint."),
      constructor<PostureGains, read_posture>(
          "posture", "Keeps the chassis level and shares the load among the wheels."),
      constructor<SwingArm, read_swing_arm>("rocker", "The arm on each side of the body."),
      constructor<SwingArm, read_swing_arm>("bogie", "The arm on each rocker."),
      constructor<Differential, read_differential>("differential", "What ties two rockers."),
      constructor<SteeringMotor, read_steering>("steering", "Steering of a wheel or module."),
      constructor<WheelScript, read_wheel>("wheel", "A wheel and its contact."),
      constructor<DriveMotor, read_drive>("drive", "A wheel's motor and brake.")};
}

}  // namespace lsos
