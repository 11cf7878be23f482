// Cost of a piece of a route: the one cost function that searches, refinement and tests share.
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

using Line2 = std::vector<Vec2>;  // points on a map, m

// Pose on a map; yaw is counter-clockwise from east.
struct Pose2 {
  Vec2 at_m = Vec2::Zero();
  double yaw_rad = 0;

  Vec2 ahead() const { return {std::cos(yaw_rad), std::sin(yaw_rad)}; }
};

// Disc on a map, such as ground that a route avoids whatever its shape.
struct Disc2 {
  Vec2 center_m = Vec2::Zero();
  double radius_m = 0;

  bool holds(const Vec2& at_m) const { return (at_m - center_m).norm() < radius_m; }
};

struct LegSummary {
  double cost = 0;  // J or m, by the aim; infinite where a hazard lies on it
  double length_m = 0, duration_s = 0, energy_j = 0;
  double slope_max_rad = 0;
  Vec2 steepest_m = Vec2::Zero();
  Hazard hazard = Hazard::none;
  Vec2 hazard_m = Vec2::Zero();  // place of the first hazard
};

// Speed at which the rover drives an arc.
double arc_speed_mps(const DriveCost& cost, double radius_m);
// Cost of an arc: slowing down for it from full speed and speeding up after it, and each radian.
struct ArcCost {
  double slowing = 0, per_rad = 0;

  double of(double bend_rad) const;
};
// Energy of an arc, including that of the other loads meanwhile, and the same as metres of driving
// on the level.
ArcCost arc_cost_j(const DriveCost& cost, double radius_m);
ArcCost arc_price_m(const DriveCost& cost, double radius_m);

class RouteCost {
 public:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  RouteCost(GroundMap& map, const StanceFinder& finder, RouteAim aim,
            std::vector<Disc2> avoided = {});
  // The same costs on another map of the ground.
  RouteCost over(GroundMap& map) const;
  // Discs around start and goal within which the rover may come as near to a hazard as it likes.
  // Elsewhere, where the rover is near a limit, the ground `cross_track_margin_m` to either side
  // must be free too.
  void set_tight(std::vector<Disc2> tight) { tight_ = std::move(tight); }
  // Objects that stand on the map, and the rover's footprint (LegRequest::obstacles). A route stays
  // half the rover's diagonal and `cross_track_margin_m` away from them, so that the rover can
  // turn. In tight discs the rover, heading along the route, stays `clearance_m` away; in the first
  // of them, where it starts, it must only not touch them.
  void set_standing(std::vector<Footprint> standing, const Footprint& rover_at_rest) {
    standing_ = std::move(standing);
    rover_at_rest_ = rover_at_rest;
  }
  static constexpr double clearance_m = 0.4;
  // Greatest cross-track error assumed of a rover that follows a line.
  static constexpr double cross_track_margin_m = 0.4;
  // How far the rover may turn on the spot at the start; it sets off in no other direction.
  void set_turn_room(const TurnRoom& room) { turn_room_ = room; }
  // Limits that apply within `disc`: a rover that stands beyond a limit may leave over ground that
  // is hardly worse.
  void set_leaving(const Disc2& disc, const DriveLimits& limits) {
    leaving_ = disc;
    leaving_limits_ = limits;
  }

  // Cost of a straight piece, summed by the midpoint rule in steps of at most 1.5 map spacings;
  // infinite where a hazard lies on it. Here and in along(), a cost above `most` is infinite too,
  // and the piece is not evaluated to its end.
  double straight(const Vec2& from_m, const Vec2& to_m, double most = unlimited);
  bool is_free(const Vec2& from_m, const Vec2& to_m) {
    return std::isfinite(straight(from_m, to_m));
  }
  // Cost of the corner `at_m` of a line: slowing down for its fillet, and the fillet; where there
  // is no room for one, stopping there and turning on the spot. It is 0 for rovers that cannot turn
  // on the spot, whose lines consist of arcs, except in of_rounded_corners().
  double corner(const Vec2& before_m, const Vec2& at_m, const Vec2& after_m) const;
  // Energy and time that a corner adds; turning(): of turning on the spot, from rest to rest.
  struct CornerCost {
    double energy_j = 0, duration_s = 0;
  };
  CornerCost corner_cost(const Vec2& before_m, const Vec2& at_m, const Vec2& after_m) const;
  CornerCost turning(double by_rad) const;
  // Cost of a line: the sum of its pieces and corners.
  double along(const Line2& line, double most = unlimited);
  // The same, with slowing down for arcs where the rover cannot turn on the spot.
  double driven(const Line2& line);
  // Cost of an arc of a route along which `speeds` is carried: slowing down for it from the speed
  // reached since the last arc, and the arc. Searches and driven() add it for such a rover.
  struct ArcState {
    double share = 1;          // speed in the last arc, as a share of full speed
    double free_m = 0;         // distance driven since it ended; negative within it
    Vec2 in_m = Vec2::Zero();  // last piece of the line driven so far; zero before it
  };
  double arc(ArcState& speeds, double radius_m, double bend_rad) const {
    return price(arc_driven(speeds, radius_m, bend_rad));
  }
  // Cost of all arcs of a line that continues what `speeds` stands for: at each of its bends, also
  // that at its beginning, an arc that begins and ends half a piece away.
  double arcs(ArcState& speeds, const Line2& line) const {
    return price(arcs_driven(speeds, line));
  }
  // The same costs for lines of such a rover whose corners are rounded later: corner() returns what
  // the widest arcs that have room cost.
  RouteCost of_rounded_corners() const;
  // The same costs for a rover that drives backwards: its footprint faces the other way, and a
  // metre counts `backing_ratio` times, since drivers and cameras look ahead; of() returns energy
  // and time as they are. It is taken to stand as one that drives ahead there.
  static constexpr double backing_ratio = 2;
  RouteCost backing() const;
  // Energy and time of changing between forwards and backwards: to stop, steer and set off again.
  CornerCost gear_change() const;
  // Cost of a number of changes, each with `gear_change_m` metres on the level besides.
  static constexpr double gear_change_m = 5;
  double gear_changes(std::size_t count) const;
  // driven(), with length, duration, energy, steepest slope and first hazard.
  LegSummary of(const Line2& line);
  // Places of a line where a limit is exceeded, more than `apart_m` apart. The line is sampled
  // three times as densely as for costs, without the margin of `cross_track_margin_m` to either
  // side.
  std::vector<Vec2> hazards(const Line2& line, double apart_m);
  // Whether the rover can stop there while driving along `ahead` (unit vector). On what it does not
  // climb it neither stands safely nor sets off again.
  bool can_stand(const Vec2& at_m, const Vec2& ahead);
  // Lower bound of the cost of a metre, on top of `per_rise` for each metre of climb: the heuristic
  // of the searches.
  double least_per_metre() const { return least_per_metre_; }
  double per_rise() const { return per_rise_; }
  // Lower bound of the cost of a route of this length and climb. On rough ground it may be slightly
  // too high, since wheels meet other slopes than heights of single nodes show.
  double least(double length_m, double rise_m) const {
    return std::max(0.0, least_per_metre_ * length_m + per_rise_ * rise_m);
  }
  // Cost of a metre on even ground up the steepest slope that the rover may drive.
  double steep_per_metre() const { return steep_per_metre_; }
  // Whether a rover there would stand partly off the map, or almost so.
  bool is_at_border(const Vec2& at_m) const { return map_.inside_m(at_m) < border_m_; }
  GroundMap& map() { return map_; }
  const GroundMap& map() const { return map_; }

 private:
  CornerCost rounding(double bend_rad, double room_m) const;
  // Cost of arcs, from their energy and that of loads meanwhile, in units of the aim.
  double price(const CornerCost& arcs) const;
  CornerCost arc_driven(ArcState& speeds, double radius_m, double bend_rad) const;
  CornerCost arcs_driven(ArcState& speeds, const Line2& line) const;
  Hazard hazard_at(const Stance& stance, const Vec2& at_m, const Vec2& ahead);
  bool is_occupied(const Vec2& at_m, const Vec2& ahead) const;
  // Cost of a metre along the ground on a stance: its energy in J, or for RouteAim::risk one over
  // the share of the limits that is left.
  double rate(const Stance& stance) const;
  void find_least();

  GroundMap& map_;
  const StanceFinder& finder_;
  RouteAim aim_;
  std::vector<Disc2> avoided_, tight_;
  std::vector<Footprint> standing_;
  Footprint rover_at_rest_;
  TurnRoom turn_room_;
  Disc2 leaving_;  // none while its radius is 0
  DriveLimits leaving_limits_;
  bool is_rounding_ = false, is_backing_ = false;
  double least_per_metre_ = 1, per_rise_ = 0, steep_per_metre_ = 1;
  double border_m_ = 0;
  double cost_per_j_ = 1;  // of corners and arcs
};

}  // namespace lsos
