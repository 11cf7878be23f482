// How a rover gets from pose to pose.
#pragma once

#include <array>
#include <functional>

#include "route/search/turning.h"

namespace lsos {

// Straight on where it turns on the spot, and the yaws of poses mean nothing; else by arcs and
// straight pieces, in arcs so wide that length and arcs together cost least.
class RouteSteering {
 public:
  // What an arc of a radius costs besides its length: so many metres of driving on.
  using ArcPrice = std::function<ArcCost(double radius_m)>;

  static RouteSteering on_the_spot() { return {}; }
  // Arcs are drawn as points `step_m` apart at most.
  static RouteSteering in_turns(double radius_m, double step_m, const ArcPrice& price_m);

  // Without arcs: the rover turns on the spot.
  bool is_straight() const { return arcs_.front().radius_m == 0; }
  double length_m(const Pose2& from, const Pose2& to) const;
  // The pose that share (0..1) of the way.
  Pose2 between(const Pose2& from, const Pose2& to, double share) const;
  // With both ends.
  Line2 way(const Pose2& from, const Pose2& to) const;
  // Over all poses, two at least.
  Line2 line(const std::vector<Pose2>& poses) const;

 private:
  // Arcs that are tried.
  struct Arc {
    double radius_m = 0;
    ArcCost price_m;
  };

  RouteSteering() = default;

  TurningWay turns(const Pose2& from, const Pose2& to) const;

  std::array<Arc, 5> arcs_;
  double step_m_ = 1;
};

}  // namespace lsos
