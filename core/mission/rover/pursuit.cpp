#include "mission/rover/pursuit.h"

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// A gap that is wrong by e changes the speed by e times this. Larger: kept more closely, but above
// the inverse of the lag of steering and drives it would swing.
constexpr double gap_gain_1ps = 0.3;
// Shares of the greatest speed: it stops below the first, and sets off above the second.
constexpr double stop_share = 0.05, start_share = 0.1;
constexpr double lengthened_by_m = 0.5;  // the line, while the leader drives on
// A nearer place of the track is aimed at when it is nearer by this share, and this far.
constexpr double nearer_share = 0.2, nearer_least_m = 5;

}  // namespace

void Pursuit::update(const Leader& leader, const FollowerPose& pose,
                     std::optional<PathFollower>& follower) {
  if (has_ended_) return;
  has_begun_ = true;
  const DrivenTrack& track = leader.track;
  const bool is_on_track = follower && follower->next_waypoint() > 0;
  const bool has_driven_on = follower && (track.here_S_m() - end_S_m_).norm() >= lengthened_by_m;
  if (!is_on_track && (is_waiting_ || has_driven_on)) aim(leader, pose, follower);
  if (follower && has_driven_on) lengthen(track, pose, *follower);
  if (follower) gap_m_ = follower->remaining_m() + (track.here_S_m() - end_S_m_).norm();
  has_ended_ = leader.has_ended;
  const double wanted_mps = speed_mps(leader, pose);
  is_waiting_ = wanted_mps < (is_waiting_ ? start_share : stop_share) * limits_.speed_mps;
  if (is_waiting_ || has_ended_) return;
  if (!follower) {
    const DrivenTrack::Entry entry = track.nearest(pose.p_S_m);
    const auto at = [](const Vec2& p_S_m) { return Vec3(p_S_m.x(), p_S_m.y(), 0); };
    Path3 path_S_m{at(entry.p_S_m)};
    for (const Vec2& corner_S_m : track.corners_from(entry.next_corner)) {
      path_S_m.push_back(at(corner_S_m));
    }
    path_S_m.push_back(at(track.here_S_m()));
    follower.emplace(path_S_m, pose, limits_);
    entry_S_m_ = entry.p_S_m;
    end_S_m_ = track.here_S_m();
    next_corner_ = track.corner_count();
  }
  follower->limit_speed(wanted_mps);
}

// Chooses where to enter the track, as long as the rover is not on it: it forgets its line when the
// track has come nearer.
void Pursuit::aim(const Leader& leader, const FollowerPose& pose,
                  std::optional<PathFollower>& follower) {
  const DrivenTrack::Entry entry = leader.track.nearest(pose.p_S_m);
  const double to_track_m = (pose.p_S_m - entry.p_S_m).norm();
  if (follower) {
    const double now_m = (pose.p_S_m - entry_S_m_).norm();
    const double nearer_m = std::max(nearer_least_m, nearer_share * now_m);
    if (!is_waiting_ && to_track_m > now_m - nearer_m) return;
    follower.reset();
  }
  gap_m_ = to_track_m + entry.to_here_m;
}

void Pursuit::lengthen(const DrivenTrack& track, const FollowerPose& pose, PathFollower& follower) {
  std::vector<Vec2> more_S_m = track.corners_from(next_corner_);
  more_S_m.push_back(track.here_S_m());
  follower.extend(more_S_m, pose);
  end_S_m_ = track.here_S_m();
  next_corner_ = track.corner_count();
}

// The leader's speed, and more or less by what the gap is wrong; and at most the speed from which
// the rover stops before the leader even if that stood still:
//  v^2 / (2 a) <= gap - half lengths - clearance.
// A leader that backs up, or comes back on another way, is nearer than along its track.
double Pursuit::speed_mps(const Leader& leader, const FollowerPose& pose) const {
  const double apart_m = std::min(gap_m_, (leader.track.here_S_m() - pose.p_S_m).norm());
  const double free_m = apart_m - half_length_m_ - leader.half_length_m - pursuit_clearance_m;
  const double safe_mps = std::sqrt(2 * limits_.acceleration_mps2 * std::max(0.0, free_m));
  const double kept_mps = leader.speed_mps + gap_gain_1ps * (gap_m_ - settings_.distance_m);
  return std::min({limits_.speed_mps, kept_mps, safe_mps});
}

}  // namespace lsos
