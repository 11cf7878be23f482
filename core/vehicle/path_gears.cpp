// How a path follower changes between forwards and backwards.
#include <algorithm>
#include <numbers>

#include "driving/fillet.h"
#include "vehicle/path_follower.h"

namespace lsos {

namespace {

constexpr double slow_mps = 0.05;  // speed below which the rover may change its gear
constexpr double patience_s = 60;  // after which it goes on all the same, and is found to be stuck
constexpr double steering_mps = 2e-3;  // at which wheels are steered, and which hardly moves them

// The pose of a rover that drives backwards, as if it faced the way that it drives.
FollowerPose facing_back(const FollowerPose& pose) {
  return {pose.p_S_m,      pose.yaw_rad + std::numbers::pi,
          pose.speed_mps,  -pose.left_mps,
          -pose.pitch_rad, -pose.roll_rad};
}

}  // namespace

DriveCommand PathFollower::update(const FollowerPose& pose, double period_s) {
  if (status_ != Status::driving || is_stopping_) return stop(pose, period_s);
  find_piece(pose);
  if (is_changing_gear_) {
    if (pose.speed_mps > slow_mps && since_progress_s_ < patience_s) {
      since_progress_s_ += period_s;
      return {0, 0, false};
    }
    if (!has_steered(period_s)) {
      return {is_backward() ? -steering_mps : steering_mps, steering_mps * command_curvature_1pm_,
              false};
    }
    is_changing_gear_ = false;
  }
  if (!is_backward()) return along_line(pose, period_s);
  DriveCommand command = along_line(facing_back(pose), period_s);
  command.speed_mps = -command.speed_mps;
  return command;
}

// The wheels stay steered as they are, which bends the other way for a rover that drives back.
void PathFollower::change_gear() {
  is_changing_gear_ = true;
  steering_s_ = command_mps_ = 0;
  command_curvature_1pm_ = -command_curvature_1pm_;
  side_slip_rad_ = -side_slip_rad_;
  incline_ = {-incline_.pitch_rad, -incline_.bank_rad};
}

// Steers the wheels of a rover at rest for the arc that comes next.
bool PathFollower::has_steered(double period_s) {
  const double wanted_1pm = curvature_ahead_1pm(line_[leg_].length_m, steered_for_m);
  const double ramp_1pm = curvature_rate_1pms * period_s;
  command_curvature_1pm_ =
      std::clamp(wanted_1pm, command_curvature_1pm_ - ramp_1pm, command_curvature_1pm_ + ramp_1pm);
  if (command_curvature_1pm_ == wanted_1pm) steering_s_ += period_s;
  return steering_s_ > steering_lag_s;
}

}  // namespace lsos
