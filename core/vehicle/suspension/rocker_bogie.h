// Suspension template: a rocker on each side, and if wanted a bogie on each rocker (MER). Rockers
// turn about a line across the chassis and are tied to each other by a differential, so that the
// chassis pitches by the mean of both. Nothing is sprung.
//
// Numbers are of the left side; the right side is its mirror image. Links are named rocker_left,
// bogie_left, and by station front_left_steering, front_left_wheel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// A rocker or a bogie. Its joint's angle is positive with its front end down.
struct SwingArm {
  Vec3 p_B_pivot_m = Vec3::Zero();  // of the left one at rest; a bogie's is on the rocker
  double mass_kg = 0;               // of one, without knuckles and wheels
  // At rest, of the left one. By default the middle of what the arm joins: pivots and hubs.
  std::optional<Vec3> p_B_center_m = std::nullopt;
  // About its centre of mass. By default of a box round what the arm joins, no edge shorter than a
  // fifth of its longest or 5 cm.
  std::optional<Vec3> moments_kgm2 = std::nullopt;
  double angle_max_rad = 0;  // either way, to the stop
  double stop_stiffness_n_m_prad = 0;
  double stop_damping_n_m_sprad = 0;
  double damping_n_m_sprad = 0;  // of the bearing
};

enum class Arm { rocker, bogie };

// A wheel on the left and one on the right.
struct WheelStation {
  std::string name;           // "front"
  Vec2 p_B_m = Vec2::Zero();  // of the left wheel's middle, and of its steering axis
  bool is_steered = false;    // has a knuckle and its mass
  bool is_driven = true;      // otherwise its wheels turn freely
  Arm arm = Arm::rocker;      // that carries it
};

// What ties the rockers: a bar across the body with a link to each rocker, or gears on their
// shafts. Both turn one rocker back as far as the other turns: the kind is for readers and
// pictures.
struct Differential {
  enum class Kind { bar, gear };
  Kind kind = Kind::bar;
  Vec3 p_B_m = Vec3::Zero();
  double mass_kg = 0;  // moves with the chassis, besides its own
  double stiffness_n_m_prad = 0;
  double damping_n_m_sprad = 0;
};

struct RockerBogie {
  SwingArm rocker;
  std::optional<SwingArm> bogie;
  Differential differential;
  std::vector<WheelStation> stations;
  double knuckle_mass_kg = 0;  // of one: what is steered, without the wheel
  SteeringMotor steering;
  double wheel_mass_kg = 0;
  std::optional<Vec3> wheel_moments_kgm2;  // forward, axle, up; by default of a disc
  Wheel wheel;
  DriveMotor drive;
};

// Adds the links, their coupling, and the differential's mass to `vehicle`.
void add_rocker_bogie(VehicleConfig& vehicle, const RockerBogie& suspension);

// What does not fit together, one sentence each; empty when fine.
std::vector<std::string> rocker_bogie_faults(const RockerBogie& suspension);

// The same of stations alone.
std::vector<std::string> station_faults(const std::vector<WheelStation>& stations,
                                        double wheel_width_m);

}  // namespace lsos
