// Drives in an estimate, which are foreseen in place of followed.
#include <algorithm>
#include <cmath>

#include "mission/rover/rover_drive.h"

namespace lsos {

namespace {

// Without the last `less_m` of its length; empty where nothing is left.
Path3 cut_line_S_m(Path3 line_S_m, double less_m) {
  while (line_S_m.size() > 1) {
    const Vec3 last_m = line_S_m.back() - line_S_m[line_S_m.size() - 2];
    if (last_m.norm() > less_m) {
      line_S_m.back() -= less_m / last_m.norm() * last_m;
      return line_S_m;
    }
    less_m -= last_m.norm();
    line_S_m.pop_back();
  }
  return {};
}

}  // namespace

std::string RoverDrive::leader_id() const {
  if (!is_driving()) return "";
  if (foreseen_pursuit_) return foreseen_pursuit_->settings.leader_id;
  return pursuit_ ? pursuit_->leader_id() : "";
}

double RoverDrive::share() const {
  if (foreseen_ && !foreseen_pursuit_) return foreseen_->share();
  return follower_ && !pursuit_ ? follower_->share() : 0;
}

void RoverDrive::foresee(DriveEstimate estimate, SimTime now) {
  failure_.clear();
  blocker_id_.clear();
  foreseen_pursuit_.reset();
  foreseen_.emplace(std::move(estimate), now);
}

void RoverDrive::foresee_pursuit(const PursuitSettings& settings) {
  brake();
  foreseen_pursuit_ = ForeseenPursuit{settings, {}, 0, false};
}

DriveState RoverDrive::foreseen_state() const {
  DriveState state;
  state.status = DriveState::Status::driving;
  if (foreseen_) {
    state.remaining_m = foreseen_->remaining_m();
    state.next_point = foreseen_->next_point();
    state.is_backward = foreseen_->is_backward();
  }
  if (foreseen_pursuit_) state.remaining_m = foreseen_pursuit_->gap_m;
  state.reason = failure_;
  if (failure_.empty() && foreseen_ && foreseen_->has_ended() && !foreseen_pursuit_) {
    state.reason = foreseen_->estimate().failure;
    state.is_blocked = foreseen_->estimate().is_blocked;
    state.status = DriveState::Status::arrived;
  }
  if (foreseen_pursuit_ && foreseen_pursuit_->has_ended) {
    state.status = DriveState::Status::arrived;
  }
  if (!state.reason.empty()) state.status = DriveState::Status::failed;
  return state;
}

bool RoverDrive::carry(SimTime now) {
  has_passed_mark_ = false;
  if (!is_carried()) return false;
  const double driven_m = foreseen_->driven_m(), used_j = foreseen_->energy_j();
  const double power_w = foreseen_->power_w();
  const DriveDoubt doubt = foreseen_->doubt();
  const std::size_t marks = foreseen_->marks_passed();
  foreseen_->advance(now);
  doubt_ += foreseen_->doubt() - doubt;
  has_passed_mark_ = foreseen_->marks_passed() != marks;
  has_motion_ended_ |= has_passed_mark_;
  const SiteFrame& site = motion_->ground().site();
  const Vec3& p_S_m = foreseen_->p_S_m();
  RoverMotion::Carried to{p_S_m,
                          motion_->report().heading_rad,
                          foreseen_->driven_m() - driven_m,
                          foreseen_->energy_j() - used_j,
                          power_w,
                          foreseen_->speed_mps()};
  const Vec2& ahead_S = foreseen_->ahead_S();
  if (!ahead_S.isZero(0)) {
    to.heading_rad = site.azimuth_rad(Vec3(ahead_S.x(), ahead_S.y(), 0), p_S_m);
  }
  motion_->carry(to);
  return foreseen_->has_ended();
}

bool RoverDrive::is_left_behind(const RoverDrive& leader) const {
  return foreseen_pursuit_ && !foreseen_pursuit_->has_ended && leader.is_carried() &&
         foreseen_pursuit_->left_at != leader.foreseen_->start();
}

void RoverDrive::pursue_foreseen(const RoverDrive& leader, bool has_leader_ended, SimTime now,
                                 const std::function<DriveEstimate(const Path3&)>& on_line) {
  ForeseenPursuit& pursuit = *foreseen_pursuit_;
  const double distance_m = pursuit.settings.distance_m;
  pursuit.has_ended = has_leader_ended;
  if (!has_leader_ended && is_left_behind(leader)) {
    pursuit.left_at = leader.foreseen_->start();
    Path3 line_S_m = is_carried() ? foreseen_->line_ahead_S_m() : Path3{motion_->report().p_S_m};
    const Path3 leaders_S_m = leader.foreseen_->line_ahead_S_m();
    line_S_m.insert(line_S_m.end(), leaders_S_m.begin(), leaders_S_m.end());
    line_S_m = cut_line_S_m(std::move(line_S_m), distance_m);
    foreseen_.reset();
    if (line_S_m.size() > 1) {
      line_S_m.erase(line_S_m.begin());
      DriveEstimate estimate = on_line(line_S_m);
      // It is no faster than the one before it.
      const double leader_s = seconds(leader.foreseen_->end() - now);
      const double own_s = estimate.marks.back().time_s;
      if (own_s > 0 && own_s < leader_s) {
        for (DriveMark& mark : estimate.marks) mark.time_s *= leader_s / own_s;
      }
      foreseen_.emplace(std::move(estimate), now);
    }
  }
  pursuit.gap_m = foreseen_ ? foreseen_->remaining_m() + distance_m
                            : (leader.motion_->report().p_S_m - motion_->report().p_S_m).norm();
}

}  // namespace lsos
