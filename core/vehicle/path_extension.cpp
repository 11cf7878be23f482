// How the line of a path follower grows while it is driven.
#include <algorithm>

#include "base/error.h"
#include "base/segment.h"
#include "vehicle/path_follower.h"

namespace lsos {

namespace {

constexpr double kept_behind_m = 10;  // of the line, behind the rover
// The line before and after it is extended differ by the rounding of corners; within this of the
// distance driven so far lies the piece that the rover is on.
constexpr double same_place_m = 1;

}  // namespace

void PathFollower::extend(const std::vector<Vec2>& waypoints_S_m, const FollowerPose& pose) {
  LSOS_ASSERT(!waypoints_S_m.empty());
  if (status_ != Status::driving) return;
  double driven_m = 0;
  if (!line_.empty()) {
    const DrivingPiece& leg = line_[leg_];
    driven_m = leg.begin_m + leg.along_S.dot(pose.p_S_m - leg.from_S_m);
  }
  // The line begins where the rover was: that waypoint stays.
  if (waypoints_S_m_.size() > 1) waypoints_S_m_.pop_back();
  waypoints_S_m_.insert(waypoints_S_m_.end(), waypoints_S_m.begin(), waypoints_S_m.end());
  driven_m -= forget_driven(driven_m);
  build_line();
  if (line_.empty()) return;
  is_stopping_ = false;
  leg_ = leg_near(pose, driven_m);
  const DrivingPiece &leg = line_[leg_], &last = line_.back();
  const double travelled_m = leg.along_S.dot(pose.p_S_m - leg.from_S_m);
  const double remaining_m =
      std::max(0.0, last.begin_m + last.length_m - leg.begin_m - travelled_m);
  best_remaining_m_ += remaining_m - remaining_m_;  // a line that grows is no lack of progress
  remaining_m_ = remaining_m;
}

double PathFollower::forget_driven(double driven_m) {
  double forgotten_m = 0;
  std::size_t count = 0;
  for (; count + 2 < waypoints_S_m_.size(); ++count) {
    const double length_m = (waypoints_S_m_[count + 1] - waypoints_S_m_[count]).norm();
    if (forgotten_m + length_m > driven_m - kept_behind_m) break;
    forgotten_m += length_m;
  }
  waypoints_S_m_.erase(waypoints_S_m_.begin(),
                       waypoints_S_m_.begin() + static_cast<std::ptrdiff_t>(count));
  passed_ += count;
  return forgotten_m;
}

// The piece of the line nearest to the rover, of those about the distance that it has driven; of
// several the last, which a rover that turns at a corner is about to drive.
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
