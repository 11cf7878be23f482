// One simulated vehicle: its bodies, wheels on the soil, motors and brakes, stepped through one
// exchange period at a time. It reads only its own state and the ground.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.h"
#include "terrain/ground.h"
#include "vehicle/drive_control.h"
#include "vehicle/multibody.h"
#include "vehicle/part_pose.h"
#include "vehicle/posture_control.h"
#include "vehicle/wheel_soil.h"

namespace lsos {

// State of a vehicle at an exchange. Angles about the local vertical there: heading clockwise from
// true north, 0..2 pi; pitch nose up; roll right side down.
struct VehicleReport {
  Vec3 p_S_m = Vec3::Zero();  // reference point
  Vec3 v_S_mps = Vec3::Zero();
  double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
  double yaw_rad = 0;  // counter-clockwise from the site's east, horizontal plane
  double yaw_rate_radps = 0;
  double speed_mps = 0;             // speed of the reference point along the ground
  double slope_rad = not_modelled;  // slope of the plane fitted to the ground under the wheels
  // Inclination that gravity acts by along and across the heading: the chassis' pitch and roll, but
  // those of that plane where posture control keeps the chassis level.
  double incline_pitch_rad = 0, incline_roll_rad = 0;
  double slip = not_modelled;      // mean over driven wheels in contact
  double slip_max = not_modelled;  // slip of the wheel that slips most, with its sign
  double sinkage_m = not_modelled;
  double elevation_m = not_modelled;  // elevation of the ground under the reference point
  bool is_on_ground_data = true;      // the terrain is known under every wheel
  bool is_chassis_on_ground = false;  // it touched the ground in the last period: high-centred
  bool is_finite = true;

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, p_S_m, v_S_mps, heading_rad, pitch_rad, roll_rad, yaw_rad, yaw_rate_radps,
                 speed_mps, slope_rad, incline_pitch_rad, incline_roll_rad, slip, slip_max,
                 sinkage_m, elevation_m, is_on_ground_data, is_chassis_on_ground, is_finite);
  }
};

// Work done on the vehicle since the start, J, by its cause; negative where energy is taken away.
// The sum equals the change of the vehicle's kinetic and potential energy.
struct WorkDone {
  double motors_j = 0;  // motors of driven wheels
  double brakes_j = 0;
  double steering_j = 0;
  double limbs_j = 0;       // motors and brakes of limbs
  double suspension_j = 0;  // springs, dampers, stops, differentials
  double soil_j = 0;        // all forces on wheels
  double chassis_j = 0;     // contact of the chassis with the ground

  double sum_j() const {
    return motors_j + brakes_j + steering_j + limbs_j + suspension_j + soil_j + chassis_j;
  }
  void archive(Archive& a) {
    LSOS_ARCHIVE(a, motors_j, brakes_j, steering_j, limbs_j, suspension_j, soil_j, chassis_j);
  }
};

class Vehicle {
 public:
  // `config` must have all its links; `ground` must outlive the vehicle.
  Vehicle(const VehicleConfig& config, const Ground& ground);
  Vehicle(const Vehicle&) = delete;  // parts point into config_
  Vehicle& operator=(const Vehicle&) = delete;

  const VehicleConfig& config() const { return config_; }

  // Places the vehicle on the ground and lets it settle on its springs and limbs with brakes on.
  // Returns "" or the reason why it cannot stand there: no terrain data under a wheel, or ground
  // too steep. `joints`: positions from which its joints settle, in order of config().links; empty:
  // the initial ones.
  std::string place(const Geodetic& at, double heading_rad, const std::vector<double>& joints = {});
  // The same in the middle of a run: what was driven and used so far still counts, and what it does
  // to settle does not.
  std::string place_again(const Geodetic& at, double heading_rad,
                          const std::vector<double>& joints);
  // As place(), before it settles.
  std::string put_down(const Geodetic& at, double heading_rad,
                       const std::vector<double>& joints = {});

  // Takes effect with the next `advance`.
  void command(const DriveCommand& command);

  // Steps through `period`, a multiple of the configuration's step.
  void advance(SimTime period);

  // Makes a wheel fail, or work again; wheels are numbered in order of their links.
  void set_wheel_mode(std::size_t wheel, WheelMode mode);
  // The mode that its configuration gives the wheel.
  WheelMode wheel_mode_at_rest(std::size_t wheel) const { return layout_.wheels[wheel].mode; }
  // Makes a steering motor stay where it is whatever is commanded, or turn again; numbered in order
  // of links.
  void set_steering_stuck(std::size_t steering, bool is_stuck);

  // Vehicles on limbs: begins to move the wheels' hubs to these places under the chassis (frame B,
  // by limb), see PostureControl::move_to.
  void set_posture(const std::vector<Vec3>& hubs_B_m, bool is_level, double duration_s);
  // The same at once, for a vehicle that is placed next.
  void stand_on(const std::vector<Vec3>& hubs_B_m, bool is_level);
  // nullptr: not on limbs.
  const PostureControl* posture() const { return posture_ ? &*posture_ : nullptr; }
  // Whether posture control is to keep the chassis level.
  bool stands_level() const;
  // Whether limbs move although the vehicle stands.
  bool is_adjusting() const { return posture_ && posture_->is_adjusting(); }
  // Angles to which the joints of limbs are commanded, by limb and joint, and the real ones.
  std::vector<std::vector<double>> limb_angles_rad() const;
  std::vector<std::vector<double>> limb_positions_rad() const;
  // Where the limbs really hold the wheels' hubs (frame B, by limb).
  std::vector<Vec3> hubs_B_m() const;
  // Makes a limb's joint (by link) unable to turn, or able again.
  void set_limb_locked(int link, bool is_locked);
  std::vector<std::vector<bool>> limbs_locked() const;  // by limb and joint
  Vec3 up_B() const;                                    // local vertical in the chassis' axes

  // Parks the vehicle: brakes on, all velocities exactly zero.
  void halt();

  VehicleReport report();
  // Poses of the chassis, then of each link.
  std::vector<PartPose> part_poses() const;
  // Position (m or rad) of each joint, in order of config().links.
  std::vector<double> joint_positions() const;
  // Load on a wheel in the last step, N; wheels are numbered in order of their links.
  double wheel_load_n(std::size_t wheel) const { return wheels_[wheel].load_n; }
  const WorkDone& work() const { return work_; }
  double kinetic_j() const { return bodies_.kinetic_j(); }
  double potential_j() const;  // with gravity at the chassis, above the site's origin
  // Where the dynamics failed ("its dynamics gave a number that is not finite in step 12 ..."); ""
  // while all numbers are finite. A failed vehicle is no longer stepped.
  const std::string& fault() const { return fault_; }
  double distance_m() const { return distance_m_; }  // driven by the reference point
  double drive_j() const { return drive_j_; }  // electrical, of wheels and limbs, since the start
  double drive_w() const { return drive_w_; }  // mean over the last period

  void archive(Archive& a);
  bool is_sound() const;

 private:
  struct WheelState {
    WheelContactState contact;
    WheelMode mode = WheelMode::driven;
    double spin_target_radps = 0;
    double servo_integral_rad = 0;  // accumulated speed error
    double smooth_spin_radps = 0;   // low-pass filtered spin, for the motor's limits
    double brake_anchor_rad = 0;
    Vec3 search_S = Vec3::UnitZ();  // ground normal along which the contact point is searched
    // Values of the last step, for reports.
    double load_n = 0, sinkage_m = 0, slip = not_modelled, torque_n_m = 0;

    void archive(Archive& a) {
      LSOS_ARCHIVE(a, contact, mode, spin_target_radps, servo_integral_rad, smooth_spin_radps,
                   brake_anchor_rad, search_S, load_n, sinkage_m, slip, torque_n_m);
    }
  };
  struct SteeringState {
    double target_rad = 0;    // angle commanded
    double setpoint_rad = 0;  // angle on the way to the target, at the motor's rate
    bool is_stuck = false;

    void archive(Archive& a) { LSOS_ARCHIVE(a, target_rad, setpoint_rad, is_stuck); }
  };

  struct LimbJointState {
    double setpoint_rad = 0;
    double rate_radps = 0;  // of the setpoint; 0: the brake holds
    bool is_locked = false;

    void archive(Archive& a) { LSOS_ARCHIVE(a, setpoint_rad, rate_radps, is_locked); }
  };

  struct WheelPart {
    int link = 0;
    const Wheel* shape = nullptr;
    const DriveMotor* motor = nullptr;    // nullptr: a wheel without a motor
    std::vector<WheelSoil> soils;         // by soil number of the ground
    std::vector<double> rolling_radii_m;  // likewise, under an equal share of the weight
  };

  // Cached contact plane of the ground under a wheel; sampled in each step while the wheel brakes.
  struct ContactPlane {
    int steps_left = 0;           // steps for which it remains valid
    Vec3 p_S_m = Vec3::Zero();    // point of the rim at which the ground was sampled
    double gap_m = not_modelled;  // of that point over the plane, along its normal; NaN: no ground
    Vec3 normal_S = Vec3::UnitZ();
    int soil = 0;  // index into Ground::soils()
  };

  // Pose of the chassis and position of each joint.
  struct Placement {
    Vec3 p_SB_m = Vec3::Zero();
    std::vector<double> joints;
  };

  void step(double step_s);
  void apply_springs(double step_s);
  void apply_steering(double step_s);
  double apply_drives(double step_s);  // electrical power, W
  double apply_limbs(double step_s);   // likewise
  void update_posture();
  std::vector<Vec2> wheel_places_B_m() const;  // by layout_.wheels
  Placement on_feet(Placement placement, const Mat3& R_SB, const std::vector<Vec3>& feet_S_m) const;
  std::vector<double> initial_joints() const;
  void hold_limbs();
  Vec3 ground_center_S_m() const;
  Vec3 ground_center_velocity_S_mps() const;
  double motor_torque_n_m(const DriveMotor& motor, double spin_radps, double step_s,
                          WheelState& wheel) const;
  double brake_torque_n_m(const DriveMotor& motor, double angle_rad, double spin_radps,
                          WheelState& wheel) const;
  const ContactPlane& contact_plane(std::size_t wheel, const Vec3& rim_S_m);
  void apply_contacts(double step_s);
  void update_gravity();
  double mean_sinkage_m() const;
  void update_chassis_near_ground();
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
  std::vector<std::size_t> limb_wheels_;  // index into layout_.wheels, by limb
  int posture_steps_ = 1;                 // steps between updates of the posture
  std::vector<WheelPart> parts_;          // by layout_.wheels
  int contact_plane_steps_;  // steps that a contact plane serves after the one that samples it
  std::vector<ContactPlane> contact_planes_;  // by layout_.wheels; cleared each period
  std::vector<Vec3> underside_B_m_;           // points of the chassis that may touch the ground
  Vec3 gravity_S_mps2_ = Vec3::Zero();        // computed once a period, from the pose
  bool is_chassis_near_ground_ = false;       // determined once a period
  std::vector<WheelState> wheels_;            // by layout_.wheels
  std::vector<SteeringState> steerings_;      // by layout_.steerings
  std::optional<PostureControl> posture_;
  std::vector<std::vector<LimbJointState>> limb_joints_;  // by limb and joint
  std::vector<double> limb_loads_n_;                      // low-pass filtered, by limb
  DriveCommand command_;
  Vec3 ground_normal_S_ = Vec3::UnitZ();  // mean under the wheels in the last step
  bool is_chassis_on_ground_ = false;
  double distance_m_ = 0, drive_j_ = 0, drive_w_ = 0;
  WorkDone work_;
  std::int64_t steps_ = 0;  // since the vehicle was placed
  std::string fault_;
};

}  // namespace lsos
