#include "route/steering.h"

namespace lsos {

double Steering::length_m(const Pose2& from, const Pose2& to) const {
  if (is_straight()) return (to.at_m - from.at_m).norm();
  return lsos::length_m(shortest_turns(from, to, radius_m_));
}

Pose2 Steering::between(const Pose2& from, const Pose2& to, double share) const {
  if (is_straight()) return {from.at_m + share * (to.at_m - from.at_m), from.yaw_rad};
  const TurningWay way = shortest_turns(from, to, radius_m_);
  return along_turns(from, way, share * lsos::length_m(way));
}

Line2 Steering::way(const Pose2& from, const Pose2& to) const {
  if (is_straight()) return {from.at_m, to.at_m};
  Line2 line = turns_line(from, shortest_turns(from, to, radius_m_), step_m_);
  line.back() = to.at_m;  // without rounding
  return line;
}

Line2 Steering::line(const std::vector<Pose2>& poses) const {
  Line2 line{poses.front().at_m};
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    const Line2 way = this->way(poses[k], poses[k + 1]);
    line.insert(line.end(), way.begin() + 1, way.end());
  }
  return line;
}

}  // namespace lsos
