// One simulated vehicle: its bodies, wheels on the soil, motors and brakes, stepped through an
// exchange period at a time. It reads only itself and the ground.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.h"
#include "terrain/ground.h"
#include "vehicle/drive_control.h"
#include "vehicle/multibody.h"
#include "vehicle/part_pose.h"
#include "vehicle/wheel_soil.h"

namespace lsos {

// What can be said of a vehicle at an exchange. Angles about the local vertical there: heading
// clockwise from true north, 0..2 pi; pitch nose up; roll right side down.
struct VehicleReport {
  Vec3 p_S_m = Vec3::Zero();  // reference point
  Vec3 v_S_mps = Vec3::Zero();
  double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
  double yaw_rad = 0;  // counter-clockwise from the site's east, horizontal plane
  double yaw_rate_radps = 0;
  double speed_mps = 0;             // of the reference point along the ground
  double slope_rad = not_modelled;  // of the plane through the ground under the wheels
  double slip = not_modelled;       // mean over driven wheels in contact
  double slip_max = not_modelled;   // of the wheel that slips most, with its sign
  double sinkage_m = not_modelled;
  double elevation_m = not_modelled;  // of the ground under the reference point
  bool is_on_ground_data = true;      // the terrain is known under every wheel
  bool is_chassis_on_ground = false;  // it touched in the last period: high-centred
  bool is_finite = true;

  void archive(Archive& a) {
    a(p_S_m)(v_S_mps)(
        heading_rad)(pitch_rad)(roll_rad)(yaw_rad)(yaw_rate_radps)(speed_mps)(slope_rad)(slip)(slip_max)(sinkage_m)(elevation_m)(is_on_ground_data)(is_chassis_on_ground)(is_finite);
  }
};

// Work since the start, J, by what does it; done on the vehicle, so that what takes energy away
// is negative. Their sum is the change of its kinetic and potential energy.
struct WorkDone {
  double motors_j = 0;  // of driven wheels
  double brakes_j = 0;
  double steering_j = 0;
  double suspension_j = 0;  // springs, dampers, stops, differentials
  double soil_j = 0;        // all forces on wheels
  double chassis_j = 0;     // of the ground on the chassis

  double sum_j() const {
    return motors_j + brakes_j + steering_j + suspension_j + soil_j + chassis_j;
  }
  void archive(Archive& a) { a(motors_j)(brakes_j)(steering_j)(suspension_j)(soil_j)(chassis_j); }
};

class Vehicle {
 public:
  // `config` with all its links; `ground` must outlive the vehicle.
  Vehicle(const VehicleConfig& config, const Ground& ground);
  Vehicle(const Vehicle&) = delete;  // parts point into config_
  Vehicle& operator=(const Vehicle&) = delete;

  const VehicleConfig& config() const { return config_; }

  // Stands the vehicle on the ground at a place and lets it settle on its springs, brakes on.
  // Answers why that cannot be: the ground is not known under a wheel, or too steep to stand on;
  // "" when it stands.
  std::string place(const Geodetic& at, double heading_rad);

  // Takes effect with the next `advance`.
  void command(const DriveCommand& command);

  // Steps through `period`, a multiple of the configuration's step.
  void advance(SimTime period);

  // A wheel that fails, or works again; in order of the links that have one.
  void set_wheel_mode(std::size_t wheel, WheelMode mode);

  // Parked: brakes on, all velocities exactly zero.
  void halt();

  VehicleReport report();
  // Of the chassis, then of each link.
  std::vector<PartPose> part_poses() const;
  // Position (m or rad) of each joint, in order of config().links.
  std::vector<double> joint_positions() const;
  const WorkDone& work() const { return work_; }
  double kinetic_j() const { return bodies_.kinetic_j(); }
  double potential_j() const;  // of gravity at the chassis, above the site's origin
  // What its dynamics broke on ("step 12 of ..."), "" while all numbers are finite. A broken
  // vehicle is not stepped any more.
  const std::string& fault() const { return fault_; }
  double distance_m() const { return distance_m_; }  // driven by the reference point
  double drive_j() const { return drive_j_; }        // electrical, since the start
  double drive_w() const { return drive_w_; }        // mean over the last period

  void archive(Archive& a);

 private:
  struct WheelState {
    WheelContactState contact;
    WheelMode mode = WheelMode::driven;
    double spin_target_radps = 0;
    double servo_integral_rad = 0;  // accumulated speed error
    double smooth_spin_radps = 0;   // what the motor's limits go by
    double brake_anchor_rad = 0;
    Vec3 search_S = Vec3::UnitZ();  // normal of the ground along which its contact is looked for
    // Of the last step, for reports.
    double load_n = 0, sinkage_m = 0, slip = not_modelled, torque_n_m = 0;

    void archive(Archive& a) {
      a(contact)(mode)(
          spin_target_radps)(servo_integral_rad)(smooth_spin_radps)(brake_anchor_rad)(search_S)(load_n)(sinkage_m)(slip)(torque_n_m);
    }
  };
  struct SteeringState {
    double target_rad = 0;    // where it shall go
    double setpoint_rad = 0;  // on the way there, at the motor's rate

    void archive(Archive& a) { a(target_rad)(setpoint_rad); }
  };

  struct WheelPart {
    int link = 0;
    const Wheel* shape = nullptr;
    const DriveMotor* motor = nullptr;  // nullptr: a wheel without one
    std::vector<WheelSoil> soils;       // by the ground's number
  };

  // The ground under a wheel, as a plane that is good for a while; while it brakes anew each step.
  struct Foothold {
    int steps_left = 0;           // that it is good for
    Vec3 p_S_m = Vec3::Zero();    // where it was looked at
    double gap_m = not_modelled;  // over the plane there, along its normal; NaN: no ground
    Vec3 normal_S = Vec3::UnitZ();
    int soil = 0;  // of Ground::soils()
  };

  void step(double step_s);
  void apply_springs(double step_s);
  void apply_steering(double step_s);
  double apply_drives(double step_s);  // electrical power, W
  double motor_torque_n_m(const DriveMotor& motor, double spin_radps, double step_s,
                          WheelState& wheel) const;
  double brake_torque_n_m(const DriveMotor& motor, double angle_rad, double spin_radps,
                          WheelState& wheel) const;
  const Foothold& foothold(std::size_t wheel, const Vec3& rim_S_m);
  void apply_contacts(double step_s);
  void find_gravity();
  double mean_sinkage_m() const;
  void find_chassis_near_ground();
  void apply_chassis_contact(double step_s);
  void find_fault();
  Vec3 reference_point_S_m() const;
  Vec3 reference_velocity_S_mps() const;
  double speed_along_ground_mps() const;

  VehicleConfig config_;
  const Ground* ground_;
  Ground::Probe probe_;
  Multibody bodies_;
  WheelLayout layout_;
  std::vector<Vec3> centres_B_m_;  // centres_at_rest_B_m
  std::vector<int> spring_links_;
  std::vector<WheelPart> parts_;          // by layout_.wheels
  int foothold_steps_;                    // for which one is good
  std::vector<Foothold> footholds_;       // by layout_.wheels; anew each period
  std::vector<Vec3> underside_B_m_;       // points of the chassis that may touch the ground
  Vec3 gravity_S_mps2_ = Vec3::Zero();    // once a period, from the pose
  bool is_chassis_near_ground_ = false;   // looked at once a period
  std::vector<WheelState> wheels_;        // by layout_.wheels
  std::vector<SteeringState> steerings_;  // by layout_.steerings
  DriveCommand command_;
  Vec3 ground_normal_S_ = Vec3::UnitZ();  // mean under the wheels at the last step
  bool is_chassis_on_ground_ = false;
  double distance_m_ = 0, drive_j_ = 0, drive_w_ = 0;
  WorkDone work_;
  std::int64_t steps_ = 0;  // since it was placed
  std::string fault_;
};

}  // namespace lsos
