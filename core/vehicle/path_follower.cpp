#include "vehicle/path_follower.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "driving/fillet.h"
#include "driving/side_slip.h"
#include "driving/slope_speed.h"

namespace lsos {

namespace {

constexpr double at_end_m = 0.02;       // distance from a stop at which it counts as reached
constexpr double passed_radius_m = 1;   // waypoints this near at the start are passed
constexpr double turn_begin_rad = 1.0;  // heading error that needs a turn on the spot
constexpr double turn_done_rad = 0.03;
// Lookahead time, over which the cross-track error decays. It must be well above the lag of the
// steering, which is some tenths of a second.
constexpr double lookahead_s = 2.0;
constexpr double preview_s = 0.4;   // time by which arcs are steered early, for the same lag
constexpr double creep_mps = 0.05;  // lowest speed commanded while driving
constexpr double at_rest_mps = 0.01;
constexpr double progress_m = 0.5;      // least progress in stuck_s, else the rover is stuck
constexpr double progress_share = 0.1;  // the same for slow drives, share of the requested speed
constexpr double stuck_s = 60;
constexpr double turning_progress_rad = 0.05;  // the same for turning on the spot
constexpr double side_slip_smoothing_s =
    0.5;                                // filter from which the change of side slip is estimated
constexpr double side_slip_lead_s = 1;  // time ahead for which side slip is predicted
constexpr double side_slip_speed_min_mps = 0.01;  // side slip is not measured below this speed
constexpr double side_slip_max_rad = 0.6;
constexpr double steering_travel_m = 1;  // most travel while a curvature error is steered out
constexpr double lateral_ratio_max = 2;  // lateral over forward acceleration, off laid arcs
constexpr double incline_smoothing_s = 0.5;
constexpr double crab_turn_rate = 0.5;   // 1/s, rate at which a heading error is corrected
constexpr double stopping_limit_s = 30;  // brakes that take longer than this have failed

double wrapped_rad(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// Sine of the error, but full where the travel leads backwards: there the sine falls to 0 while the
// rover must turn the most.
double saturated_sine(double error_rad) {
  const double error = wrapped_rad(error_rad);
  return std::abs(error) < std::numbers::pi / 2 ? std::sin(error) : std::copysign(1, error);
}

}  // namespace

PathFollower::PathFollower(const Path3& path_S_m, const FollowerPose& start,
                           const FollowerLimits& limits,
                           const std::vector<std::size_t>& gear_changes)
    : waypoints_S_m_{start.p_S_m}, limits_(limits) {
  const std::vector<std::size_t> changes =
      limits.is_crabbing ? std::vector<std::size_t>{} : gear_changes;
  // A waypoint on which the rover stands is behind it; a rover that cannot turn on the spot would
  // circle around it.
  const double here_m = std::min(limits.arrival_radius_m, passed_radius_m);
  const auto is_within = [&](const Vec3& p, double radius_m) {
    return (p.head<2>() - start.p_S_m).norm() <= radius_m;
  };
  auto first = path_S_m.begin();
  if (changes.empty()) {
    while (first + 1 < path_S_m.end() && is_within(*first, here_m)) ++first;
  } else if (is_within(*first, passed_radius_m)) {
    // A path with changes is driven from its first point on, however near the others are.
    ++first;
  }
  passed_ = static_cast<std::size_t>(first - path_S_m.begin());
  for (auto p = first; p < path_S_m.end(); ++p) waypoints_S_m_.push_back(p->head<2>());
  for (const std::size_t at : changes) gear_changes_.push_back(at < passed_ ? 0 : at - passed_ + 1);
  build_line();
  if (!line_.empty()) remaining_m_ = line_.back().begin_m + line_.back().length_m;
  best_remaining_m_ = remaining_m_;
  best_heading_error_rad_ = 2 * std::numbers::pi;
  heading_rad_ = start.yaw_rad;
  is_turning_ = limits_.can_turn_on_spot && !limits_.is_crabbing;
  is_changing_gear_ = !gear_changes_.empty() && !line_.empty();
  is_stopping_ = line_.empty() || (first + 1 == path_S_m.end() && is_within(*first, here_m));
}

void PathFollower::build_line() {
  DrivingLimits limits;
  limits.speed_mps = limits_.speed_mps;
  limits.acceleration_mps2 = limits.lateral_mps2 = limits_.acceleration_mps2;
  limits.radius_min_m = limits_.radius_min_m;
  limits.can_turn_on_spot = limits_.can_turn_on_spot;
  limits.corner_offset_m = limits_.corner_offset_m;
  limits.steering_m = limits_.steering_m;
  line_ = driving_line(waypoints_S_m_, limits, gear_changes_);
}

void PathFollower::find_piece(const FollowerPose& pose) {
  while (leg_ + 1 < line_.size()) {
    const DrivingPiece& leg = line_[leg_];
    const double travelled_m = leg.along_S.dot(pose.p_S_m - leg.from_S_m);
    if (travelled_m < leg.length_m - (leg.ends_in_stop ? at_end_m : 0)) break;
    const bool changes = line_[leg_ + 1].is_backward != leg.is_backward;
    if (changes) change_gear();
    if (!changes && leg.ends_in_stop) is_turning_ = limits_.can_turn_on_spot;
    ++leg_;
    best_heading_error_rad_ = 2 * std::numbers::pi;
    if (changes) break;
  }
}

DriveCommand PathFollower::along_line(const FollowerPose& pose, double period_s) {
  const DrivingPiece& leg = line_[leg_];
  const Vec2 offset_m = pose.p_S_m - leg.from_S_m;
  const double cross_track_m = leg.along_S.x() * offset_m.y() - leg.along_S.y() * offset_m.x();
  const double travelled_m = leg.along_S.dot(offset_m);
  const double to_end_m = leg.length_m - travelled_m;
  const double heading_error_rad =
      wrapped_rad(pose.yaw_rad - std::atan2(leg.along_S.y(), leg.along_S.x()));
  const DrivingPiece& last = line_.back();
  remaining_m_ = std::max(0.0, last.begin_m + last.length_m - leg.begin_m - travelled_m);

  if (std::abs(cross_track_m) > limits_.cross_track_max_m) {
    status_ = Status::failed;
    is_off_line_ = true;
    reason_ = fmt::format("strayed {:.1f} m from its path, {:.1f} m before the end",
                          std::abs(cross_track_m), remaining_m_);
    return stop(pose, period_s);
  }
  if (makes_no_progress(std::abs(heading_error_rad), period_s)) {
    status_ = Status::failed;
    is_stuck_ = true;
    reason_ =
        fmt::format("stuck: no progress in {} s, {:.1f} m before the end", stuck_s, remaining_m_);
    return stop(pose, period_s);
  }
  if (&leg == &last && to_end_m <= at_end_m) {
    is_stopping_ = true;
    return stop(pose, period_s);
  }
  update_incline(pose, heading_error_rad, period_s);
  if (limits_.is_crabbing) return crab(pose, to_end_m, cross_track_m, period_s);
  if (limits_.can_turn_on_spot && std::abs(heading_error_rad) > turn_begin_rad) is_turning_ = true;
  if (is_turning_ && std::abs(heading_error_rad) > turn_done_rad) {
    return turn(heading_error_rad, pose);
  }
  is_turning_ = false;
  return drive(pose, to_end_m, cross_track_m, heading_error_rad, period_s);
}

void PathFollower::ramp_speed(double to_end_m, double period_s) {
  const DrivingPiece& leg = line_[leg_];
  command_mps_ = std::min({command_mps_ + limits_.acceleration_mps2 * period_s, leg.speed_max_mps,
                           std::max(creep_mps, braking_speed_mps(to_end_m))});
}

// Speed from which the end speed of each leg can still be reached. End speeds assume the full
// deceleration; where less is available, the legs beyond the present one are evaluated too.
double PathFollower::braking_speed_mps(double to_end_m) const {
  const double slowing_mps2 =
      braking_mps2(incline_, limits_.acceleration_mps2, limits_.gravity_mps2);
  double least_mps = std::numeric_limits<double>::infinity();
  double distance_m = std::max(0.0, to_end_m);
  for (std::size_t leg = leg_; leg < line_.size(); ++leg) {
    if (leg > leg_) distance_m += line_[leg].length_m;
    const double end_mps = line_[leg].end_speed_mps;
    least_mps = std::min(least_mps, std::sqrt(end_mps * end_mps + 2 * slowing_mps2 * distance_m));
    const bool is_full = slowing_mps2 >= limits_.acceleration_mps2;
    if (is_full || 2 * slowing_mps2 * distance_m > command_mps_ * command_mps_) break;
  }
  return least_mps;
}

// Inclination along the direction of travel, which differs from the heading while crabbing.
void PathFollower::update_incline(const FollowerPose& pose, double heading_error_rad,
                                  double period_s) {
  const double aside_rad = limits_.is_crabbing ? -heading_error_rad : 0;  // yaw to travel, left
  const Vec2 up_B(std::sin(pose.pitch_rad), std::sin(pose.roll_rad) * std::cos(pose.pitch_rad));
  const Vec2 ahead_B(std::cos(aside_rad), std::sin(aside_rad)), left_B(-ahead_B.y(), ahead_B.x());
  const double share = std::min(1.0, period_s / incline_smoothing_s);
  const auto follow = [&](double& rad, double up) {
    rad += share * (std::asin(std::clamp(up, -1.0, 1.0)) - rad);
  };
  follow(incline_.pitch_rad, up_B.dot(ahead_B));
  follow(incline_.bank_rad, up_B.dot(left_B));
}

double PathFollower::slope_limit_mps() const {
  return slope_speed_mps(incline_, limits_.level_speed_mps, limits_.acceleration_mps2,
                         limits_.gravity_mps2);
}

PathFollower::SideSlip PathFollower::side_slip(const FollowerPose& pose, double period_s) {
  if (pose.speed_mps <= side_slip_speed_min_mps) return {side_slip_rad_, side_slip_rad_};
  const double ahead_mps =
      std::sqrt(std::max(0.0, pose.speed_mps * pose.speed_mps - pose.left_mps * pose.left_mps));
  const double now_rad =
      std::clamp(std::atan2(pose.left_mps, std::max(ahead_mps, side_slip_speed_min_mps)),
                 -side_slip_max_rad, side_slip_max_rad);
  const double changed_rad = now_rad - side_slip_rad_;
  const double soon_rad = side_slip_rad_ + side_slip_lead_s / side_slip_smoothing_s * changed_rad;
  side_slip_rad_ += std::min(1.0, period_s / side_slip_smoothing_s) * changed_rad;
  return {now_rad, soon_rad};
}

DriveCommand PathFollower::drive(const FollowerPose& pose, double to_end_m, double cross_track_m,
                                 double heading_error_rad, double period_s) {
  ramp_speed(to_end_m, period_s);
  // On a cross slope a rover does not travel along its heading. The travel must follow the line.
  const auto [side_slip_rad, side_slip_soon_rad] = side_slip(pose, period_s);
  // Cross-track error e decays critically damped over the lookahead l. In distance travelled:
  //  e'' + (2/l) e' + e/l^2 = 0,  about the curvature of the arc itself.
  const double lookahead_m = std::max(limits_.lookahead_min_m, lookahead_s * pose.speed_mps);
  const double most_1pm = 1 / limits_.radius_min_m, ramp_1pm = curvature_rate_1pms * period_s;
  const double preview_m =
      std::max(preview_s * pose.speed_mps, gear_changes_.empty() ? 0 : steered_for_m);
  const double wanted_1pm = std::clamp(
      curvature_ahead_1pm(to_end_m, preview_m) - cross_track_m / (lookahead_m * lookahead_m) -
          2 * saturated_sine(heading_error_rad + side_slip_rad) / lookahead_m,
      -most_1pm, most_1pm);
  const double off_1pm = std::abs(wanted_1pm - command_curvature_1pm_);
  command_curvature_1pm_ =
      std::clamp(wanted_1pm, command_curvature_1pm_ - ramp_1pm, command_curvature_1pm_ + ramp_1pm);
  // In turns without a laid arc the lateral acceleration is limited.
  const double turn_1pm = std::max(std::abs(command_curvature_1pm_), 1e-6);
  const double lateral_max_mps2 = lateral_ratio_max * limits_.acceleration_mps2;
  command_mps_ =
      std::min(command_mps_, std::max(creep_mps, std::sqrt(lateral_max_mps2 / turn_1pm)));
  // The speed is limited further so that wheels are steered in time, side slip does not carry the
  // rover off its line, and the brakes hold it downhill; it slows down at twice its acceleration at
  // most.
  const double steered_mps = steering_travel_m * curvature_rate_1pms / std::max(off_1pm, 1e-6);
  const double slowed_mps = command_mps_ - 2 * limits_.acceleration_mps2 * period_s;
  const double kept_mps =
      std::min({steered_mps, side_slip_speed_mps(side_slip_soon_rad), slope_limit_mps()});
  command_mps_ = std::min({command_mps_, std::max({creep_mps, kept_mps, slowed_mps}),
                           std::max(speed_limit_mps_, slowed_mps)});
  return {command_mps_, command_mps_ * command_curvature_1pm_, false};
}

// Follows the line sideways with constant heading: the wheels point in the direction of travel.
DriveCommand PathFollower::crab(const FollowerPose& pose, double to_end_m, double cross_track_m,
                                double period_s) {
  const double slowed_mps = command_mps_ - 2 * limits_.acceleration_mps2 * period_s;
  ramp_speed(to_end_m, period_s);
  command_mps_ =
      std::min(command_mps_, std::max(std::min(slope_limit_mps(), speed_limit_mps_), slowed_mps));
  const DrivingPiece& leg = line_[leg_];
  const Vec2 left_S(-leg.along_S.y(), leg.along_S.x());
  const double back_mps =
      std::clamp(-cross_track_m / lookahead_s, -0.5 * command_mps_, 0.5 * command_mps_);
  const Vec2 v_S_mps = command_mps_ * leg.along_S + back_mps * left_S;
  const Vec2 ahead_S(std::cos(pose.yaw_rad), std::sin(pose.yaw_rad));
  const double turn_rad = wrapped_rad(heading_rad_ - pose.yaw_rad);
  const double turn_radps =
      std::clamp(crab_turn_rate * turn_rad, -limits_.turn_rate_radps, limits_.turn_rate_radps);
  return {v_S_mps.dot(ahead_S), turn_radps, false,
          ahead_S.x() * v_S_mps.y() - ahead_S.y() * v_S_mps.x()};
}

// Curvature of the leg that the rover will be on after `preview_m`.
double PathFollower::curvature_ahead_1pm(double to_end_m, double preview_m) const {
  std::size_t leg = leg_;
  for (preview_m -= to_end_m; preview_m > 0; preview_m -= line_[leg].length_m) {
    if (line_[leg].ends_in_stop || leg + 1 == line_.size()) break;
    ++leg;
  }
  return line_[leg].curvature_1pm;
}

DriveCommand PathFollower::turn(double heading_error_rad, const FollowerPose& pose) {
  command_mps_ = command_curvature_1pm_ = 0;
  // The rover comes to rest first and then turns, slowing down towards the end.
  if (pose.speed_mps > 2 * creep_mps) return {0, 0, false};
  const double rate =
      std::clamp(-heading_error_rad, -limits_.turn_rate_radps, limits_.turn_rate_radps);
  const double slowest = 0.1 * limits_.turn_rate_radps;
  return {0, std::abs(rate) < slowest ? std::copysign(slowest, rate) : rate, false};
}

DriveCommand PathFollower::stop(const FollowerPose& pose, double period_s) {
  command_mps_ = command_curvature_1pm_ = 0;
  stopping_s_ += period_s;
  const bool is_at_rest = pose.speed_mps < at_rest_mps;
  if (status_ == Status::driving && !is_at_rest && stopping_s_ > stopping_limit_s) {
    status_ = Status::failed;
    reason_ = fmt::format("the brakes do not hold: still sliding at {:.2f} m/s", pose.speed_mps);
  } else if (status_ == Status::driving && is_at_rest) {
    const double distance_m = (pose.p_S_m - waypoints_S_m_.back()).norm();
    if (distance_m <= limits_.arrival_radius_m) {
      status_ = Status::arrived;
      remaining_m_ = 0;
    } else {
      status_ = Status::failed;
      reason_ = fmt::format("came to rest {:.2f} m from the last waypoint, its radius is {} m",
                            distance_m, limits_.arrival_radius_m);
    }
  }
  return {0, 0, true};
}

double PathFollower::share() const {
  if (line_.empty()) return 1;
  return 1 - remaining_m_ / (line_.back().begin_m + line_.back().length_m);
}

double PathFollower::turn_remaining_rad(double yaw_rad) const {
  if (line_.empty() || !is_turning_) return 0;
  const Vec2& along_S = line_[leg_].along_S;
  const double back_rad = line_[leg_].is_backward ? std::numbers::pi : 0;
  return wrapped_rad(std::atan2(along_S.y(), along_S.x()) + back_rad - yaw_rad);
}

std::vector<FollowerPose> PathFollower::poses_ahead(const FollowerPose& pose, double length_m,
                                                    double step_m) const {
  std::vector<FollowerPose> poses;
  if (line_.empty() || is_turning_ || is_stopping_) return poses;
  std::size_t leg = leg_;
  double along_m = std::max(0.0, line_[leg].along_S.dot(pose.p_S_m - line_[leg].from_S_m));
  const Vec2 off_m = pose.p_S_m - (line_[leg].from_S_m + along_m * line_[leg].along_S);
  for (double travelled_m = step_m; travelled_m < length_m + step_m; travelled_m += step_m) {
    along_m += std::min(step_m, length_m - (travelled_m - step_m));
    while (along_m > line_[leg].length_m) {
      if (line_[leg].ends_in_stop || leg + 1 == line_.size()) return poses;
      along_m -= line_[leg].length_m;
      ++leg;
    }
    const double off_share = std::max(0.0, 1 - travelled_m / (2 * limits_.lookahead_min_m));
    FollowerPose next;
    next.p_S_m = line_[leg].from_S_m + along_m * line_[leg].along_S + off_share * off_m;
    next.yaw_rad = limits_.is_crabbing ? heading_rad_
                                       : std::atan2(line_[leg].along_S.y(), line_[leg].along_S.x());
    if (line_[leg].is_backward) next.yaw_rad += std::numbers::pi;
    poses.push_back(next);
  }
  return poses;
}

// Fillets cut corners by some centimetres, so the remaining length along the line is a little less
// than the remaining distance from waypoint to waypoint.
std::size_t PathFollower::next_waypoint() const {
  std::size_t next = waypoints_S_m_.size() - 1;
  for (double rest_m = 0; next > 1; --next) {
    rest_m += (waypoints_S_m_[next] - waypoints_S_m_[next - 1]).norm();
    if (rest_m >= remaining_m_) break;
  }
  return passed_ + (next > 0 ? next - 1 : 0);
}

bool PathFollower::makes_no_progress(double heading_error_rad, double period_s) {
  const double step_m = std::min(progress_m, progress_share * limits_.speed_mps * stuck_s);
  const bool has_moved = remaining_m_ < best_remaining_m_ - step_m;
  const bool is_turning = is_turning_ || heading_error_rad > turn_begin_rad;
  const bool has_turned =
      is_turning && heading_error_rad < best_heading_error_rad_ - turning_progress_rad;
  if (has_moved) best_remaining_m_ = remaining_m_;
  if (has_turned) best_heading_error_rad_ = heading_error_rad;
  // A heading that swings back and forth is no progress.
  if (!is_turning && has_moved) best_heading_error_rad_ = 2 * std::numbers::pi;
  since_progress_s_ = has_moved || has_turned ? 0 : since_progress_s_ + period_s;
  return since_progress_s_ > stuck_s;
}

void PathFollower::archive(Archive& a) {
  a.tag("follower");
  LSOS_ARCHIVE(a, waypoints_S_m_, gear_changes_, limits_, leg_, is_turning_, is_changing_gear_,
               steering_s_, is_stopping_, command_mps_, command_curvature_1pm_, side_slip_rad_,
               incline_.pitch_rad, incline_.bank_rad, heading_rad_, remaining_m_, best_remaining_m_,
               best_heading_error_rad_, stopping_s_, since_progress_s_, status_, reason_, is_stuck_,
               is_off_line_, passed_, speed_limit_mps_);
  if (!a.is_reading()) return;
  if (!has_sound_waypoints()) a.refuse("saved state holds a line that nobody can follow");
  build_line();
}

bool PathFollower::has_sound_waypoints() const {
  constexpr double far_m = 1e8;
  const double numbers = limits_.speed_mps + limits_.acceleration_mps2 + limits_.radius_min_m +
                         limits_.turn_rate_radps + limits_.corner_offset_m + limits_.steering_m +
                         limits_.lookahead_min_m;
  return std::isfinite(numbers) && limits_.speed_mps > 0 && limits_.acceleration_mps2 > 0 &&
         std::ranges::all_of(
             waypoints_S_m_,
             [](const Vec2& p_S_m) { return p_S_m.cwiseAbs().maxCoeff() < far_m; }) &&
         std::ranges::is_sorted(gear_changes_) &&
         (gear_changes_.empty() || gear_changes_.back() < waypoints_S_m_.size());
}

}  // namespace lsos
