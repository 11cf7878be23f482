// What a piece of a route costs: the one function that searching, refining and tests share.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/footprint.h"
#include "route/cost/leg_request.h"
#include "route/cost/stance.h"
#include "route/cost/turn_room.h"

namespace lsos {

using Line2 = std::vector<Vec2>;  // on a map, m

// On a map; yaw counter-clockwise from east.
struct Pose2 {
  Vec2 at_m = Vec2::Zero();
  double yaw_rad = 0;

  Vec2 ahead() const { return {std::cos(yaw_rad), std::sin(yaw_rad)}; }
};

// Ground that a route keeps off, whatever it looks like.
struct Disc2 {
  Vec2 center_m = Vec2::Zero();
  double radius_m = 0;

  bool holds(const Vec2& at_m) const { return (at_m - center_m).norm() < radius_m; }
};

struct LegCost {
  double cost = 0;  // J or m, by the aim; infinite where a hazard lies on it
  double length_m = 0, duration_s = 0, energy_j = 0;
  double slope_max_rad = 0;
  Vec2 steepest_m = Vec2::Zero();
  Hazard hazard = Hazard::none;
  Vec2 hazard_m = Vec2::Zero();  // the first
};

// How fast the rover drives an arc.
double arc_speed_mps(const DriveCost& cost, double radius_m);
// Of an arc: of slowing down for it from full speed and up again after it, and of each radian.
struct ArcCost {
  double slowing = 0, per_rad = 0;

  double of(double bend_rad) const;
};
// Its energy with that of all else meanwhile, and that as metres on the level.
ArcCost arc_cost_j(const DriveCost& cost, double radius_m);
ArcCost arc_price_m(const DriveCost& cost, double radius_m);

class LegCosts {
 public:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  LegCosts(GroundMap& map, const StanceFinder& finder, RouteAim aim,
           std::vector<Disc2> avoided = {});
  // The same on another map of the ground.
  LegCosts over(GroundMap& map) const;
  // Ground within which the rover may come as near to a hazard as it likes: where it stands, where
  // it is to stand. Elsewhere it keeps off by as much as it may stray to either side.
  void set_tight(std::vector<Disc2> tight) { tight_ = std::move(tight); }
  // Things that stand on the map, and the ground that the rover covers (LegRequest::obstacles). A
  // route keeps off them by half the rover's diagonal, so that the rover can turn. On tight ground
  // the rover, heading along the route, only keeps `clearance_m` off them, and on the first of the
  // tight discs, where it stands, it need not touch them.
  void set_standing(std::vector<Footprint> standing, const Footprint& rover_at_rest) {
    standing_ = std::move(standing);
    rover_at_rest_ = rover_at_rest;
  }
  static constexpr double clearance_m = 0.4;
  // A rover that follows a line may be so far beside it.
  static constexpr double stray_m = 0.4;
  // How far the rover may turn on the spot where it stands; it sets off no other way.
  void set_turn_room(const TurnRoom& room) { turn_room_ = room; }
  // Where the rover stands beyond a limit it may leave over ground that is no worse.
  void set_leaving(const Disc2& disc, const DriveLimits& limits) {
    leaving_ = disc;
    leaving_limits_ = limits;
  }

  // Of a straight piece, by the midpoint rule in steps of 1.5 spacings of the map at most; infinite
  // where a hazard lies on it. What costs more than `most` is infinite too, here and in along(),
  // and not looked at to its end.
  double straight(const Vec2& from_m, const Vec2& to_m, double most = unlimited);
  bool is_free(const Vec2& from_m, const Vec2& to_m) {
    return std::isfinite(straight(from_m, to_m));
  }
  // Of the corner `at_m` of a line: of slowing down for the arc that rounds it, and of the arc;
  // where there is no room for one, of stopping there and turning on the spot. Rovers that cannot
  // are planned in arcs: nothing.
  double corner(const Vec2& before_m, const Vec2& at_m, const Vec2& after_m) const;
  // What a corner adds, and what turning so far on the spot does, from rest to rest.
  struct Cornering {
    double energy_j = 0, duration_s = 0;
  };
  Cornering cornering(const Vec2& before_m, const Vec2& at_m, const Vec2& after_m) const;
  Cornering turning(double by_rad) const;
  // Of a line: the sum of its pieces and corners.
  double along(const Line2& line, double most = unlimited);
  // The same with slowing down for the arcs of a rover that cannot turn on the spot.
  double driven(const Line2& line);
  // An arc of a way over which `speeds` is carried: of slowing down for it, from what was reached
  // since the last, and of the arc; what search and driven() add for such a rover.
  struct Speeds {
    double share = 1;          // of full speed, in the last arc
    double free_m = 0;         // driven since it ended
    Vec2 in_m = Vec2::Zero();  // the last piece of the line, where one is driven on
  };
  double arc(Speeds& speeds, double radius_m, double bend_rad) const {
    return price(arc_driven(speeds, radius_m, bend_rad));
  }
  // Of all arcs of a line that is driven on over: at each of its bends, the one to it too, an arc
  // that begins and ends half a piece away.
  double arcs(Speeds& speeds, const Line2& line) const { return price(arcs_driven(speeds, line)); }
  // For lines of such a rover whose corners are rounded later, by arcs as wide as there is room
  // for: corner() tells what those cost.
  void set_rounding(bool is_rounding) { is_rounding_ = is_rounding; }
  // driven() with all that is told of a line.
  LegCost of(const Line2& line);
  // Places of a line where a limit is passed, so far apart, looked at three times as closely as
  // costs are and without room to stray.
  std::vector<Vec2> hazards(const Line2& line, double apart_m);
  // Whether the rover can stop there, driving ahead (unit): what it does not climb it does not
  // stand on safely either, nor leave again.
  bool can_stand(const Vec2& at_m, const Vec2& ahead);
  // Of a metre at least, after `per_rise` for each metre of climb: what guides the search.
  double least_per_metre() const { return least_per_metre_; }
  double per_rise() const { return per_rise_; }
  // Of so long a way with so much climb; but for what the wheels feel of rough ground otherwise
  // than its height tells.
  double least(double length_m, double rise_m) const {
    return std::max(0.0, least_per_metre_ * length_m + per_rise_ * rise_m);
  }
  // Of a metre on good ground up the steepest slope that the rover may drive.
  double steep_per_metre() const { return steep_per_metre_; }
  // A rover there would stand partly off the map, or next to that.
  bool is_at_border(const Vec2& at_m) const { return map_.inside_m(at_m) < border_m_; }
  GroundMap& map() { return map_; }
  const GroundMap& map() const { return map_; }

 private:
  Cornering rounding(double bend_rad, double room_m) const;
  double price(const Cornering& arcs) const;
  Cornering arc_driven(Speeds& speeds, double radius_m, double bend_rad) const;
  Cornering arcs_driven(Speeds& speeds, const Line2& line) const;
  Hazard hazard_at(const Stance& stance, const Vec2& at_m, const Vec2& ahead);
  SlopeDrive drive_at(const Stance& stance) const;
  bool is_occupied(const Vec2& at_m, const Vec2& ahead) const;
  double rate(const Stance& stance) const;
  void find_least();

  GroundMap& map_;
  const StanceFinder& finder_;
  RouteAim aim_;
  std::vector<Disc2> avoided_, tight_;
  std::vector<Footprint> standing_;
  Footprint rover_at_rest_;
  TurnRoom turn_room_;
  Disc2 leaving_;  // nothing, without a radius
  DriveLimits leaving_limits_;
  bool is_rounding_ = false;
  double least_per_metre_ = 1, per_rise_ = 0, steep_per_metre_ = 1;
  double border_m_ = 0;
  double cost_per_j_ = 1;  // of corners
};

}  // namespace lsos
