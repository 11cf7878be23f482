// How the line of a path follower changes while it is driven.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/segment.h"
#include "vehicle/path_follower.h"

namespace lsos {

namespace {

constexpr double kept_behind_m = 10;  // of the line, behind the rover
// The line before and after it is extended differ by the rounding of corners; within this of the
// distance driven so far lies the piece that the rover is on.
constexpr double same_place_m = 1;
// A place of the path that lies farther from the one where the rover was, along the path, must be
// nearer by this share of the difference to be taken for its place.
constexpr double elsewhere_share = 0.1;

}  // namespace

void PathFollower::extend(const std::vector<Vec2>& waypoints_S_m, const FollowerPose& pose) {
  LSOS_ASSERT(!waypoints_S_m.empty() && gear_changes_.empty());
  if (status_ != Status::driving) return;
  forget_driven(pose);
  const auto on = line_.empty() ? DrivingPiece{} : line_[leg_];
  const double along_m = line_.empty() ? 0 : driven_m(on, pose);
  // The line begins where the rover was: that waypoint stays.
  if (waypoints_S_m_.size() > 1) waypoints_S_m_.pop_back();
  waypoints_S_m_.insert(waypoints_S_m_.end(), waypoints_S_m.begin(), waypoints_S_m.end());
  build_line();
  if (line_.empty()) return;
  is_stopping_ = false;
  // Only what is near the end before may have changed, as a corner is rounded by the room behind
  // it.
  leg_ = leg_again(on, pose, along_m);
  const double remaining_m =
      std::max(0.0, line_.back().begin_m + line_.back().length_m - driven_m(line_[leg_], pose));
  best_remaining_m_ += remaining_m - remaining_m_;  // a line that grows is no lack of progress
  remaining_m_ = remaining_m;
}

void PathFollower::begin_again(const FollowerPose& pose) {
  if (status_ != Status::driving) return;
  double length_m = 0;
  for (std::size_t i = 1; i < waypoints_S_m_.size(); ++i) {
    length_m += (waypoints_S_m_[i] - waypoints_S_m_[i - 1]).norm();
  }
  const double driven_m = length_m - remaining_m_;
  std::size_t next = 1;
  double begin_m = 0, least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < waypoints_S_m_.size(); ++i) {
    const Vec2 &from_S_m = waypoints_S_m_[i - 1], &to_S_m = waypoints_S_m_[i];
    const double piece_m = (to_S_m - from_S_m).norm();
    const double share = nearest_share(from_S_m, to_S_m, pose.p_S_m);
    const double off_m = (pose.p_S_m - from_S_m - share * (to_S_m - from_S_m)).norm();
    const double counted_m =
        off_m + elsewhere_share * std::abs(begin_m + share * piece_m - driven_m);
    if (counted_m <= least_m) {
      least_m = counted_m;
      next = i;
    }
    begin_m += piece_m;
  }
  // The gear of the piece that leads to this waypoint stays: the path begins at the rover.
  Path3 path_S_m;
  std::vector<std::size_t> gear_changes;
  const bool backs_up = !gear_changes_.empty();
  if (backs_up) path_S_m.emplace_back(pose.p_S_m.x(), pose.p_S_m.y(), 0);
  for (const std::size_t at : gear_changes_) gear_changes.push_back(at < next ? 0 : at - next + 1);
  for (std::size_t i = next; i < waypoints_S_m_.size(); ++i) {
    path_S_m.emplace_back(waypoints_S_m_[i].x(), waypoints_S_m_[i].y(), 0);
  }
  if (path_S_m.empty()) path_S_m.emplace_back(waypoints_S_m_[0].x(), waypoints_S_m_[0].y(), 0);
  const std::size_t passed = passed_ + next - (backs_up ? 2 : 1);
  const double speed_limit_mps = speed_limit_mps_;
  *this = PathFollower(path_S_m, pose, limits_, gear_changes);
  passed_ += passed;
  speed_limit_mps_ = speed_limit_mps;
}

double PathFollower::driven_m(const DrivingPiece& leg, const FollowerPose& pose) {
  return leg.begin_m + leg.along_S.dot(pose.p_S_m - leg.from_S_m);
}

void PathFollower::forget_driven(const FollowerPose& pose) {
  if (line_.empty()) return;
  double behind_m = driven_m(line_[leg_], pose) - kept_behind_m;
  std::size_t count = 0;
  for (; count + 2 < waypoints_S_m_.size(); ++count) {
    behind_m -= (waypoints_S_m_[count + 1] - waypoints_S_m_[count]).norm();
    if (behind_m < 0) break;
  }
  if (count == 0) return;
  waypoints_S_m_.erase(waypoints_S_m_.begin(),
                       waypoints_S_m_.begin() + static_cast<std::ptrdiff_t>(count));
  passed_ += count;
  // What lies far behind the rover is missing in front, and the first corners may be rounded
  // otherwise: distances are the same as before from the end only.
  const DrivingPiece on = line_[leg_];
  const double to_end_m = line_.back().begin_m + line_.back().length_m - driven_m(on, pose);
  build_line();
  if (line_.empty()) return;
  leg_ = leg_again(on, pose, line_.back().begin_m + line_.back().length_m - to_end_m);
}

// The piece that the rover was on before the line was built anew, or the nearest one where that has
// changed. `driven_m`: distance that the rover has driven of the new line.
std::size_t PathFollower::leg_again(const DrivingPiece& on, const FollowerPose& pose,
                                    double driven_m) const {
  for (std::size_t i = 0; i < line_.size(); ++i) {
    if (line_[i].from_S_m != on.from_S_m || line_[i].along_S != on.along_S) continue;
    if (std::abs(this->driven_m(line_[i], pose) - driven_m) < same_place_m) return i;
  }
  return leg_near(pose, driven_m);
}

// The piece of the line nearest to the rover, of those about the distance that it has driven.
std::size_t PathFollower::leg_near(const FollowerPose& pose, double driven_m) const {
  std::size_t nearest = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line_.size(); ++i) {
    const DrivingPiece& piece = line_[i];
    const bool is_last = i + 1 == line_.size();
    if (piece.begin_m + piece.length_m < driven_m - same_place_m && !is_last) continue;
    if (piece.begin_m > driven_m + same_place_m) break;
    const Vec2 end_S_m = piece.from_S_m + piece.length_m * piece.along_S;
    const double distance_m = point_distance_m(piece.from_S_m, end_S_m, pose.p_S_m);
    if (distance_m > least_m) continue;
    least_m = distance_m;
    nearest = i;
  }
  return nearest;
}

}  // namespace lsos
