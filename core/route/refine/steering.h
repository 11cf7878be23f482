// Steering function: how a rover drives from pose to pose.
#pragma once

#include <array>
#include <functional>

#include "route/search/dubins_path.h"

namespace lsos {

// Straight lines for a rover that turns on the spot, for which yaws of poses have no meaning;
// otherwise Dubins paths, of the radius at which length and arcs together cost least.
class RouteSteering {
 public:
  // Cost of an arc of a radius besides its length, in metres of driving on.
  using ArcPrice = std::function<ArcCost(double radius_m)>;

  static RouteSteering on_the_spot() { return {}; }
  // `step_m`: distance of the points of arcs, see arc_line().
  static RouteSteering dubins(double radius_m, double step_m, const ArcPrice& price_m);

  // Whether there are no arcs, as the rover turns on the spot.
  bool is_straight() const { return arcs_.front().radius_m == 0; }
  double length_m(const Pose2& from, const Pose2& to) const;
  // Pose at a share (0..1) of the path from pose to pose.
  Pose2 between(const Pose2& from, const Pose2& to, double share) const;
  // Points of the path from pose to pose, with both ends.
  Line2 path(const Pose2& from, const Pose2& to) const;
  // Line through all poses, two at least.
  Line2 line(const std::vector<Pose2>& poses) const;

 private:
  // A radius that is tried.
  struct Arc {
    double radius_m = 0;
    ArcCost price_m;
  };

  RouteSteering() = default;

  DubinsPath turns(const Pose2& from, const Pose2& to) const;

  std::array<Arc, 5> arcs_;
  double step_m_ = 1;
};

}  // namespace lsos
