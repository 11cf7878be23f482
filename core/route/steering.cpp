#include "route/steering.h"

namespace lsos {

namespace {

// Arcs are as wide as that makes a way no longer than so much: wide ones are driven faster.
constexpr double wider[] = {16, 8, 4, 2};
constexpr double longer = 1.02;

}  // namespace

TurningWay RouteSteering::turns(const Pose2& from, const Pose2& to) const {
  const TurningWay tightest = shortest_turns(from, to, radius_m_);
  const double most_m = longer * lsos::length_m(tightest);
  for (const double ratio : wider) {
    const TurningWay way = shortest_turns(from, to, ratio * radius_m_);
    if (lsos::length_m(way) <= most_m) return way;
  }
  return tightest;
}

double RouteSteering::length_m(const Pose2& from, const Pose2& to) const {
  if (is_straight()) return (to.at_m - from.at_m).norm();
  return lsos::length_m(turns(from, to));
}

Pose2 RouteSteering::between(const Pose2& from, const Pose2& to, double share) const {
  if (is_straight()) return {from.at_m + share * (to.at_m - from.at_m), from.yaw_rad};
  const TurningWay way = turns(from, to);
  return along_turns(from, way, share * lsos::length_m(way));
}

Line2 RouteSteering::way(const Pose2& from, const Pose2& to) const {
  if (is_straight()) return {from.at_m, to.at_m};
  Line2 line = turns_line(from, turns(from, to), step_m_);
  line.back() = to.at_m;  // without rounding
  return line;
}

Line2 RouteSteering::line(const std::vector<Pose2>& poses) const {
  Line2 line{poses.front().at_m};
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    const Line2 way = this->way(poses[k], poses[k + 1]);
    line.insert(line.end(), way.begin() + 1, way.end());
  }
  return line;
}

}  // namespace lsos
