// Follows a driving line: turns towards it, holds it by feedback on cross-track and heading error,
// keeps its speeds, stops and turns at sharp corners, and comes to rest at its end.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/archive.h"
#include "driving/driving_line.h"
#include "driving/slope_speed.h"
#include "vehicle/drive_control.h"

namespace lsos {

struct FollowerLimits {
  double speed_mps = 1;  // along the line
  // Speed from which the rover can stop on level ground; on a descent it is lowered so that the
  // stopping distance stays the same.
  double level_speed_mps = 1;
  double acceleration_mps2 = 0.2;
  double arrival_radius_m = 1;   // the rover must come to rest within this of the last waypoint
  double radius_min_m = 5;       // radius of the tightest turn while driving
  double turn_rate_radps = 0.2;  // on the spot
  bool can_turn_on_spot = true;
  double gravity_mps2 = 9.81;
  double lookahead_min_m = 2.5;  // distance over which the cross-track error decays at low speed
  bool is_crabbing = false;      // follows the line without turning into it
  // How far from a corner it is rounded, and how far it drives while it steers into an arc.
  double corner_offset_m = fillet_offset_m, steering_m = steering_distance_m;
  // Greatest cross-track error to either side; beyond it the drive fails.
  double cross_track_max_m = std::numeric_limits<double>::infinity();

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, speed_mps, level_speed_mps, acceleration_mps2, gravity_mps2, arrival_radius_m,
                 radius_min_m, turn_rate_radps, can_turn_on_spot, lookahead_min_m, is_crabbing,
                 corner_offset_m, steering_m, cross_track_max_m);
  }
};

// Pose and motion of the rover in the horizontal plane of the site frame.
struct FollowerPose {
  Vec2 p_S_m;
  double yaw_rad = 0;                  // counter-clockwise from east
  double speed_mps = 0;                // magnitude
  double left_mps = 0;                 // its component across the heading: side slip, or crabbing
  double pitch_rad = 0, roll_rad = 0;  // of the ground, see VehicleReport::incline_pitch_rad
};

class PathFollower {
 public:
  enum class Status { driving, arrived, failed };
  friend constexpr Status last_value(Status) { return Status::failed; }

  PathFollower() = default;
  // `path_S_m` has at least one waypoint; only x and y matter. The line begins at the rover; the
  // first waypoints count as passed as long as they are within the arrival radius (at most 1 m) of
  // it. `gear_changes`: indices of waypoints, ascending, at which it changes between forwards and
  // backwards, 0: it begins backwards; while crabbing they have no meaning.
  PathFollower(const Path3& path_S_m, const FollowerPose& start, const FollowerLimits& limits,
               const std::vector<std::size_t>& gear_changes = {});

  // Moves the end of the line: the last waypoint is replaced by these, of which there is at least
  // one. What lies well behind the rover is forgotten.
  void extend(const std::vector<Vec2>& waypoints_S_m, const FollowerPose& pose);
  // The rover was put elsewhere, at rest: it goes on straight to the waypoint behind the place of
  // its path that is nearest to it.
  void begin_again(const FollowerPose& pose);
  // Limits the speed from now on, besides what the line and the ground allow.
  void limit_speed(double speed_mps) { speed_limit_mps_ = speed_mps; }

  // Whether it backs up, or is to.
  bool is_backward() const { return !line_.empty() && line_[leg_].is_backward; }

  // Called once per exchange period; the command holds until the next call.
  DriveCommand update(const FollowerPose& pose, double period_s);

  Status status() const { return status_; }
  const std::string& reason() const { return reason_; }
  bool is_stuck() const { return is_stuck_; }        // the reason of a failure
  bool is_off_line() const { return is_off_line_; }  // likewise
  // Index, in the path given to the constructor, of the waypoint that comes next.
  std::size_t next_waypoint() const;
  double remaining_m() const { return remaining_m_; }
  double requested_mps() const { return limits_.speed_mps; }
  // Remaining angle of a turn on the spot, counter-clockwise; 0 while it does not turn.
  double turn_remaining_rad(double yaw_rad) const;
  // Predicted poses on the next `length_m` of the line, every `step_m`, for a rover at `pose` whose
  // cross-track error decays over the lookahead. They end where the rover comes to rest before.
  std::vector<FollowerPose> poses_ahead(const FollowerPose& pose, double length_m,
                                        double step_m) const;
  // Share of the line that has been driven, 0..1.
  double share() const;

  void archive(Archive& a);
  bool is_sound() const { return leg_ < line_.size() || (leg_ == 0 && line_.empty()); }

 private:
  bool has_sound_waypoints() const;
  // Passes to the piece of the line that the rover is on.
  void find_piece(const FollowerPose& pose);
  void change_gear();
  bool has_steered(double period_s);
  // The command for a rover that faces along the line, as one that backs up does not.
  DriveCommand along_line(const FollowerPose& pose, double period_s);
  DriveCommand drive(const FollowerPose& pose, double to_end_m, double cross_track_m,
                     double heading_error_rad, double period_s);
  double curvature_ahead_1pm(double to_end_m, double preview_m) const;
  DriveCommand turn(double heading_error_rad, const FollowerPose& pose);
  DriveCommand stop(const FollowerPose& pose, double period_s);
  DriveCommand crab(const FollowerPose& pose, double to_end_m, double cross_track_m,
                    double period_s);
  void update_incline(const FollowerPose& pose, double heading_error_rad, double period_s);
  double braking_speed_mps(double to_end_m) const;
  double slope_limit_mps() const;
  void ramp_speed(double to_end_m, double period_s);
  // Side slip angle, from heading to travel, left positive: now, and predicted for side_slip_lead_s
  // ahead.
  struct SideSlip {
    double now_rad = 0, soon_rad = 0;
  };
  SideSlip side_slip(const FollowerPose& pose, double period_s);
  bool makes_no_progress(double heading_error_rad, double period_s);
  void build_line();
  // On a line on which the rover backs up, its wheels are steered for the arc that begins within so
  // much: such arcs are short and begin at rest.
  static constexpr double steered_for_m = 0.5;
  // Distance along the line of a rover on one of its pieces.
  static double driven_m(const DrivingPiece& leg, const FollowerPose& pose);
  void forget_driven(const FollowerPose& pose);
  std::size_t leg_near(const FollowerPose& pose, double driven_m) const;
  std::size_t leg_again(const DrivingPiece& on, const FollowerPose& pose, double driven_m) const;

  std::vector<Vec2> waypoints_S_m_;        // beginning where the rover was
  std::vector<std::size_t> gear_changes_;  // indices of these waypoints
  FollowerLimits limits_;
  std::vector<DrivingPiece> line_;  // derived from the three before

  std::size_t leg_ = 0;
  bool is_turning_ = false;
  bool is_changing_gear_ = false;  // comes to rest and steers before it drives the other way
  double steering_s_ = 0;          // how long the wheels have been commanded to be steered for that
  bool is_stopping_ = false;
  double command_mps_ = 0;  // rate-limited
  double command_curvature_1pm_ = 0;
  double side_slip_rad_ = 0;  // low-pass filtered
  Incline incline_;           // low-pass filtered
  double heading_rad_ = 0;    // to be kept while crabbing
  double remaining_m_ = 0;
  double best_remaining_m_ = 0;
  double best_heading_error_rad_ = 0;
  double since_progress_s_ = 0;
  double stopping_s_ = 0;
  Status status_ = Status::driving;
  std::string reason_;
  bool is_stuck_ = false, is_off_line_ = false;
  std::size_t passed_ = 0;  // waypoints within reach at the start, and forgotten ones
  double speed_limit_mps_ = std::numeric_limits<double>::infinity();
};

}  // namespace lsos
