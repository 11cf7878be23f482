#include "route/refine/steering.h"

#include <cmath>
#include <limits>

namespace lsos {

namespace {

// Radii that are tried, in units of the tightest. The tightest comes first: its path is the
// shortest and mostly rules out others before they are computed.
constexpr std::array<double, 5> wider{1, 2, 4, 8, 16};

}  // namespace

RouteSteering RouteSteering::dubins(double radius_m, double step_m, const ArcPrice& price_m) {
  RouteSteering steering;
  steering.step_m_ = step_m;
  for (std::size_t k = 0; k < wider.size(); ++k) {
    steering.arcs_[k] = {wider[k] * radius_m, price_m(wider[k] * radius_m)};
  }
  return steering;
}

DubinsPath RouteSteering::turns(const Pose2& from, const Pose2& to) const {
  DubinsPath best{};
  double least_m = std::numeric_limits<double>::infinity();
  const PosePair poses(from, to);
  for (const Arc& arc : arcs_) {
    const auto path = dubins_path(poses, arc.radius_m, least_m);
    if (!path) continue;
    double sum_m = lsos::length_m(*path);
    for (const DubinsPiece& piece : *path) {
      sum_m += arc.price_m.of(std::abs(piece.curvature_1pm) * piece.length_m);
    }
    if (sum_m >= least_m) continue;
    least_m = sum_m;
    best = *path;
  }
  return best;
}

double RouteSteering::length_m(const Pose2& from, const Pose2& to) const {
  if (is_straight()) return (to.at_m - from.at_m).norm();
  return lsos::length_m(turns(from, to));
}

Pose2 RouteSteering::between(const Pose2& from, const Pose2& to, double share) const {
  if (is_straight()) return {from.at_m + share * (to.at_m - from.at_m), from.yaw_rad};
  const DubinsPath path = turns(from, to);
  return along_dubins(from, path, share * lsos::length_m(path));
}

Line2 RouteSteering::path(const Pose2& from, const Pose2& to) const {
  if (is_straight()) return {from.at_m, to.at_m};
  Line2 line = dubins_line(from, turns(from, to), step_m_);
  line.back() = to.at_m;  // exactly, without rounding errors
  return line;
}

Line2 RouteSteering::line(const std::vector<Pose2>& poses) const {
  Line2 line{poses.front().at_m};
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    const Line2 path = this->path(poses[k], poses[k + 1]);
    line.insert(line.end(), path.begin() + 1, path.end());
  }
  return line;
}

}  // namespace lsos
