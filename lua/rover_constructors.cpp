// lsos.rover and its parts.
#include "lua/rover_constructors.h"

#include <fmt/format.h>

#include <numbers>

#include "base/sim_time.h"
#include "lua/constructors.h"
#include "vehicle/rover_spec.h"

namespace lsos {

namespace {

struct Chassis {
  Inertia inertia;
  Vec3 center_of_mass_m = Vec3::Zero();
  Vec3 size_m = Vec3::Zero();
  double clearance_m = 0;
};

// lsos.wheel: what is of one wheel.
struct WheelScript {
  Wheel wheel;
  double mass_kg = 0;
};

struct Spring {
  double stiffness_npm = 0, damping_nspm = 0;
  double travel_up_m = 0, travel_down_m = 0;
};

bool is_positive(const Vec3& v) { return v.minCoeff() > 0; }

// Of a box with its mass spread evenly.
Vec3 box_moments_kgm2(double mass_kg, const Vec3& size_m) {
  const Vec3 squares = size_m.cwiseProduct(size_m);
  return mass_kg / 12 *
         Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
}

void read_chassis(TableReader& t, Chassis& chassis) {
  t.number(required, "mass_kg", chassis.inertia.mass_kg, positive,
           "With load, without wheel modules.");
  t.vec3(required, "size_m", chassis.size_m, "Length, width, height of its box.");
  t.number(required, "clearance_m", chassis.clearance_m, not_negative,
           "From the ground to the box's underside at rest.");
  t.vec3(required, "center_of_mass_m", chassis.center_of_mass_m,
         "Forward, left, up from the ground centre of the wheelbase at rest.");
  std::optional<Vec3> moments_kgm2;
  t.vec3(optional, "inertia_kgm2", moments_kgm2,
         "Principal moments about its centre of mass (default: of the box, mass spread evenly).");
  if (chassis.size_m != Vec3::Zero() && !is_positive(chassis.size_m)) {
    t.fault("size_m: all three must be more than 0 m");
  }
  if (moments_kgm2 && !is_positive(*moments_kgm2)) {
    t.fault("inertia_kgm2: all three must be more than 0 kg m2");
  }
  chassis.inertia.moments_kgm2 =
      moments_kgm2.value_or(box_moments_kgm2(chassis.inertia.mass_kg, chassis.size_m));
}

void read_module(TableReader& t, WishboneModule& module) {
  Vec3 position_m = Vec3::Zero();
  t.text(required, "name", module.name, "As in the log: 'front_left'.");
  t.vec3(required, "position_m", position_m, "Of the steering axis: forward, left; z is 0.");
  if (position_m.z() != 0) t.fault("position_m: z must be 0, the wheels stand on the ground");
  module.p_B_m = position_m.head<2>();
}

void read_wheel(TableReader& t, WheelScript& script) {
  Wheel& wheel = script.wheel;
  t.number(required, "radius_m", wheel.radius_m, {0, 10, true}, "Rolling radius.");
  t.number(required, "width_m", wheel.width_m, {0, 10, true}, "Of the tread.");
  t.number(required, "mass_kg", script.mass_kg, positive, "Of one wheel.");
  t.number(required, "normal_stiffness_npm", wheel.normal_stiffness_npm, positive,
           "Of wheel and ground, along the ground's normal.");
  t.number(required, "normal_damping_nspm", wheel.normal_damping_nspm, not_negative,
           "Along the ground's normal.");
  t.number(required, "tangential_damping_nspm", wheel.tangential_damping_nspm, not_negative,
           "Along the ground.");
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
  t.number(required, "efficiency", motor.efficiency, {0, 1, true},
           "Mechanical out over electrical in.");
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

void read_wishbone(TableReader& t, Wishbone& wishbone) {
  WheelScript wheel;
  Spring spring;
  t.list(required, "modules", "module", wishbone.modules, "Where wheel modules are.");
  t.number(required, "arm_mass_kg", wishbone.arm_mass_kg, positive,
           "Of one module: moves with the spring, is not steered.");
  t.number(required, "knuckle_mass_kg", wishbone.knuckle_mass_kg, positive,
           "Of one module: what is steered, without wheels.");
  t.made(required, "spring", "spring", spring, "Of one module.");
  t.made(required, "steering", "steering", wishbone.steering, "Of one module.");
  t.numbers(required, "wheel_offsets_m", wishbone.wheel_offsets_m, any_number,
            "Of a module's wheels along the axle from the steering axis, left positive.");
  t.made(required, "wheel", "wheel", wheel, "Every wheel.");
  t.made(required, "drive", "drive", wishbone.drive, "The motor of every wheel.");
  wishbone.wheel = wheel.wheel;
  wishbone.wheel_mass_kg = wheel.mass_kg;
  wishbone.stiffness_npm = spring.stiffness_npm;
  wishbone.damping_nspm = spring.damping_nspm;
  wishbone.travel_up_m = spring.travel_up_m;
  wishbone.travel_down_m = spring.travel_down_m;
}

// A rover's physics step divides the exchange period exactly.
void read_step(TableReader& t, VehicleConfig& vehicle) {
  double step_s = seconds(vehicle.step);
  t.number(required, "step_s", step_s, {1e-5, seconds(exchange_period)},
           "Physics step; divides 0.1 s.");
  const SimTime step = from_seconds(step_s);
  if (std::abs(seconds(step) - step_s) > 1e-12 || exchange_period % step != SimTime::zero()) {
    t.fault(fmt::format("step_s = {}: must divide the exchange period of {} s, as 0.005 does",
                        step_s, seconds(exchange_period)));
  } else {
    vehicle.step = step;
  }
}

void read_rover(TableReader& t, RoverSpec& spec) {
  std::string name;
  Chassis chassis;
  VehicleConfig& vehicle = spec.vehicle;
  t.api_version();
  t.text(optional, "name", name, "The file's name, for readers; nothing else is allowed.");
  t.text(required, "doc", spec.doc, "One sentence that a mission planner understands.");
  t.made(required, "chassis", "chassis", chassis, "Body and load.");
  t.made(required, "suspension", "wishbone", spec.suspension, "Springs, steering and wheels.");
  read_step(t, vehicle);
  t.number(required, "cruise_speed_mps", vehicle.cruise_speed_mps, positive,
           "When an event gives no speed.");
  t.number(required, "speed_max_mps", vehicle.speed_max_mps, positive, "On level ground.");
  t.number(required, "acceleration_mps2", vehicle.acceleration_mps2, positive,
           "Speeding up and slowing down along a path.");
  t.boolean(optional, "can_turn_on_spot", vehicle.can_turn_on_spot, "Default false.");
  t.number(optional, "turning_radius_min_m", vehicle.turning_radius_min_m, not_negative,
           "While driving (default 2.5).");
  t.texts(optional, "assumptions", vehicle.assumptions,
          "Sentences about numbers that have no source; they go into summary.json.");
  if (vehicle.cruise_speed_mps > vehicle.speed_max_mps) {
    t.fault("cruise_speed_mps is above speed_max_mps");
  }
  if (t.L() == nullptr) return;
  spec.name = script_name(t.place().file);
  spec.place = t.place();
  vehicle.type = spec.name;
  vehicle.chassis = chassis.inertia;
  vehicle.p_BC_m = chassis.center_of_mass_m;
  vehicle.chassis_size_m = chassis.size_m;
  vehicle.chassis_clearance_m = chassis.clearance_m;
  if (!name.empty() && name != spec.name) {
    t.fault(fmt::format("name = '{}': must be '{}', the name of the file", name, spec.name));
  }
}

}  // namespace

std::vector<Constructor> rover_constructors() {
  return {constructor<RoverSpec, read_rover>(rover_kind, "What a script in rovers/ returns."),
          constructor<Chassis, read_chassis>("chassis", "The body that the suspension carries."),
          constructor<Wishbone, read_wishbone>(
              "wishbone", "Independently sprung, steered wheel modules, each with its wheels."),
          constructor<WishboneModule, read_module>("module", "One wheel module's place."),
          constructor<Spring, read_spring>("spring", "Spring and damper of a wheel module."),
          constructor<SteeringMotor, read_steering>("steering", "Steering of a wheel module."),
          constructor<WheelScript, read_wheel>("wheel", "A wheel and its contact."),
          constructor<DriveMotor, read_drive>("drive", "A wheel's motor and brake.")};
}

}  // namespace lsos
