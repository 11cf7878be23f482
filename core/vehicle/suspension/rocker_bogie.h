// Suspension template: a rocker on each side and, optionally, a bogie on each rocker (MER). The
// rockers turn about a line across the chassis and are tied to each other by a differential, so the
// chassis pitches by the mean of both. Nothing is sprung.
//
// Numbers describe the left side; the right side is its mirror image. Links are named rocker_left,
// bogie_left, and by station front_left_steering, front_left_wheel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vehicle/vehicle_config.h"

namespace lsos {

// A rocker or a bogie. The angle of its joint is positive with its front end down.
struct SwingArm {
  Vec3 p_B_pivot_m = Vec3::Zero();  // pivot of the left arm at rest; a bogie's is on the rocker
  double mass_kg = 0;               // one arm, without knuckles and wheels
  // Centre of mass of the left arm at rest; default: the mean of the points it joins (pivots and
  // hubs).
  std::optional<Vec3> p_B_center_m = std::nullopt;
  // Moments about the centre of mass; default: those of a box around the points it joins, each edge
  // at least a fifth of its longest one and at least 5 cm.
  std::optional<Vec3> moments_kgm2 = std::nullopt;
  double angle_max_rad = 0;  // to the stop, either direction
  double stop_stiffness_n_m_prad = 0;
  double stop_damping_n_m_sprad = 0;
  double damping_n_m_sprad = 0;  // bearing
};

enum class Arm { rocker, bogie };

// A pair of wheels, one on the left and one on the right.
struct WheelStation {
  std::string name;           // "front"
  Vec2 p_B_m = Vec2::Zero();  // centre of the left wheel and its steering axis
  bool is_steered = false;    // steered wheels have a knuckle and its mass
  bool is_driven = true;      // false: the wheels turn freely
  Arm arm = Arm::rocker;      // the arm that carries the wheels
};

// Mechanism that ties the rockers: a bar across the body with a link to each rocker, or gears on
// their shafts. Both turn one rocker back as far as the other turns; the kind matters only to
// readers and pictures.
struct Differential {
  enum class Kind { bar, gear };
  Kind kind = Kind::bar;
  Vec3 p_B_m = Vec3::Zero();
  double mass_kg = 0;  // moves with the chassis, in addition to its mass
  double stiffness_n_m_prad = 0;
  double damping_n_m_sprad = 0;
};

struct RockerBogie {
  SwingArm rocker;
  std::optional<SwingArm> bogie;
  Differential differential;
  std::vector<WheelStation> stations;
  double knuckle_mass_kg = 0;  // one knuckle: the steered mass without the wheel
  SteeringMotor steering;
  double wheel_mass_kg = 0;
  std::optional<Vec3> wheel_moments_kgm2;  // forward, axle, up; default: those of a disc
  Wheel wheel;
  DriveMotor drive;
};

// Adds the links, their coupling, and the differential's mass to `vehicle`.
void add_rocker_bogie(VehicleConfig& vehicle, const RockerBogie& suspension);

// Inconsistencies, one sentence each; empty if there are none.
std::vector<std::string> rocker_bogie_faults(const RockerBogie& suspension);

// The same for the stations alone.
std::vector<std::string> station_faults(const std::vector<WheelStation>& stations,
                                        double wheel_width_m);

}  // namespace lsos
