#include "route/route_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/segment.h"
#include "route/car_route.h"
#include "route/cost/explain.h"
#include "route/cost/standing_obstacles.h"
#include "route/refine/optimise.h"
#include "route/refine/simplify.h"
#include "route/search/grid_search.h"
#include "route/search/reachability.h"

namespace lsos {

namespace {

// Half widths of the corridors, in lengths of the leg, and the least one.
constexpr double corridors[] = {0.25, 1, 2.5};
constexpr double corridor_min_m = 20;
// Least half width for rovers that cannot turn on the spot, in turning radii.
constexpr double half_width_radii = 5;
// A leg shorter than this has no direction.
constexpr double same_point_m = 1e-3;
// Radius around start and goal within which the rover keeps no distance from hazards.
constexpr double tight_m = 2;
// A rover that stands beyond a limit may leave over ground that is worse by the factor
// `leaving_worse` in slope and unevenness and by `leaving_clearance_m` in clearance, within
// `leaving_reaches` times the distance of its wheels.
constexpr double leaving_worse = 1.1, leaving_clearance_m = 0.02, leaving_reaches = 1.5;
// Greatest number of attempts to plan a leg, to which one is added for each `attempt_every_m` of
// it, until a denser check finds no hazard on the line.
constexpr int attempts_base = 12;
constexpr double attempt_every_m = 50;
// Share of the room beside the tightest arc that an avoided disc may take up.
constexpr double passing_share = 0.9;
// Greatest number of poses that the searches for a leg expand in all, some seconds of work.
constexpr std::size_t leg_poses_max = 600'000;
// Greatest number of nodes of a map: where a search expands all of 60 million, nodes and queue take
// some three gigabytes, for each rover that is planned for at the same time.
constexpr double nodes_max = 6e7;

Vec3 on_ground(GroundMap& map, Ground::Probe& probe, const Vec2& at_m) {
  const Vec3 p_S_m = map.frame().p_S_m(at_m);
  const GroundSample sample = probe.sample(p_S_m);
  return sample.is_ground() ? Vec3(p_S_m - sample.gap_m * sample.up_S) : p_S_m;
}

class LegPlanner {
 public:
  LegPlanner(const Ground& ground, const DriveCost& cost, const LegRequest& request)
      : ground_(ground),
        request_(request),
        finder_(cost),
        frame_(ground.site(), request.start_S_m),
        spacing_m_(map_spacing_m(cost)),
        radius_m_(turning_margin * cost.turning_radius_min_m),
        goal_m_(frame_.at(request.goal_S_m)),
        standing_(request.obstacles, frame_),
        probe_(ground) {
    for (const AvoidedDisc& disc : request.avoided) {
      avoided_.push_back(passable({frame_.at(disc.center_S_m), disc.radius_m}));
    }
    if (cost.can_turn_on_spot) {
      turn_room_ =
          turn_room(request.obstacles.rover_at_rest, Vec2::Zero(),
                    std::numbers::pi / 2 - request.start_heading_rad, standing_.footprints());
    }
  }

  PlannedLeg run() {
    std::vector<double> half_widths_m;
    for (const double share : corridors) {
      const double half_width_m = std::max(half_width_min_m(), share * goal_m_.norm());
      if (fits(goal_m_, half_width_m)) half_widths_m.push_back(half_width_m);
    }
    if (half_widths_m.empty()) refuse_length();
    for (const double half_width_m : half_widths_m) {
      if (try_within(half_width_m, half_width_m == half_widths_m.back())) break;
    }
    return leg_;
  }

 private:
  // Whether the map of a leg is small enough to search.
  bool fits(const Vec2& goal_m, double half_width_m) const {
    const Vec2 size_m = goal_m.cwiseAbs() + Vec2::Constant(2 * half_width_m);
    return size_m.prod() / (spacing_m_ * spacing_m_) <= nodes_max;
  }

  // Length of the longest leg in the direction of the goal that can be planned, by bisection.
  double longest_m() const {
    const double share = *std::ranges::min_element(corridors);
    double fits_m = 0, fails_m = goal_m_.norm();
    for (int halvings = 0; halvings < 40; ++halvings) {
      const double length_m = (fits_m + fails_m) / 2;
      const double half_width_m = std::max(half_width_min_m(), share * length_m);
      (fits(length_m * goal_m_.normalized(), half_width_m) ? fits_m : fails_m) = length_m;
    }
    return fits_m;
  }

  double half_width_min_m() const {
    return finder_.cost().can_turn_on_spot ? corridor_min_m
                                           : std::max(corridor_min_m, half_width_radii * radius_m_);
  }

  // A disc close ahead of a rover that cannot turn on the spot blocks all of its routes, so it is
  // shrunk until the tightest arc passes it.
  Disc2 passable(const Disc2& disc) const {
    if (finder_.cost().can_turn_on_spot) return disc;
    const double heading_rad = request_.start_heading_rad;
    const Vec2 left(-std::cos(heading_rad), std::sin(heading_rad));
    double room_m = 0;
    for (const double side : {1.0, -1.0}) {
      const double away_m = (disc.center_m - side * radius_m_ * left).norm();
      room_m = std::max(room_m, std::abs(away_m - radius_m_));
    }
    return {disc.center_m, std::min(disc.radius_m, passing_share * room_m)};
  }

  // False where a wider corridor might hold a route.
  bool try_within(double half_width_m, bool is_last) {
    const Vec2 start_m = Vec2::Zero();
    // The start is one of the nodes.
    const auto whole = [&](const Vec2& at_m) -> Vec2 {
      return spacing_m_ * (at_m / spacing_m_).array().floor().matrix();
    };
    GroundMap map(ground_, frame_, whole(start_m.cwiseMin(goal_m_) - Vec2::Constant(half_width_m)),
                  start_m.cwiseMax(goal_m_) + Vec2::Constant(half_width_m), spacing_m_);
    find_leaving(map);
    before_optimising_.clear();
    Vec2 nearest_m;
    Reachability reach;
    std::optional<Vec2> passed_m;
    std::string at_goal = fault_to_stop_at(map, finder_, goal_m_);
    if (at_goal.empty()) at_goal = standing_.fault_at(goal_m_);
    const int attempts = attempts_base + static_cast<int>(goal_m_.norm() / attempt_every_m);
    for (int k = 0; k < attempts; ++k) {
      passed_m.reset();
      turns_too_wide_ = are_turns_at_border_ = is_start_blocked_ = false;
      RouteCost costs(map, finder_, request_.aim, avoided_);
      costs.set_tight({{start_m, tight_m}, {goal_m_, tight_m}});
      costs.set_leaving(leaving_, leaving_limits_);
      costs.set_standing(standing_.footprints(), request_.obstacles.rover_at_rest);
      costs.set_turn_room(turn_room_);
      // Reachability is cheap beside the search, which expands all that can be reached before it
      // gives up.
      reach = find_reachability(costs, start_m, goal_m_, !at_goal.empty());
      nearest_m = reach.nearest_m;
      if (reach.answer != Reachability::Answer::joined) break;
      const Stretches route = finder_.cost().can_turn_on_spot ? over_nodes(costs, nearest_m)
                                                              : over_poses(costs, nearest_m);
      if (!std::isfinite(driven(costs, route))) break;
      // A limit may be exceeded between the samples of the costs: the next attempt avoids those
      // places.
      for (const Vec2& at_m : hazards(costs, route, step_m())) {
        if (is_near_end(at_m)) continue;
        passed_m = passed_m.value_or(at_m);
        avoided_.push_back({at_m, step_m()});
      }
      if (!passed_m && finder_.cost().can_turn_on_spot) {
        if (const auto thing = blocked_turn(corners(route.front().line))) {
          return refuse(map,
                        fmt::format("there is no room to turn beside '{}'", standing_.id(*thing)),
                        nearest_m);
        }
      }
      if (!passed_m) {
        fill_result(map, costs, route);
        return true;
      }
    }
    const bool is_joined = reach.answer == Reachability::Answer::joined;
    const bool is_open = is_joined ? !turns_too_wide_ || are_turns_at_border_ : reach.is_at_border;
    if (!is_last && is_open) return false;
    if (!at_goal.empty()) return refuse(map, "the goal is " + at_goal, nearest_m);
    if (passed_m) {
      const Stance there = best_stance(map, finder_, *passed_m);
      const Hazard found = hazard(there, finder_.cost());
      std::string where = found == Hazard::none ? "where the ground is rough"
                                                : describe(found, there, finder_.cost());
      const auto thing = standing_.near(*passed_m, RouteCost::cross_track_margin_m);
      if (thing && found == Hazard::none) where = fmt::format("beside '{}'", standing_.id(*thing));
      return refuse(map,
                    fmt::format("each of {} routes examined passes a limit somewhere, the last {}",
                                attempts, where),
                    *passed_m);
    }
    return refuse(map, why_cut_off(map, reach), nearest_m);
  }

  // Object that a rover turning on the spot would touch at one of the corners of a route.
  std::optional<std::size_t> blocked_turn(const Line2& route_m) const {
    for (std::size_t k = 1; k + 1 < route_m.size(); ++k) {
      const Vec2 in_m = route_m[k] - route_m[k - 1], out_m = route_m[k + 1] - route_m[k];
      const TurnRoom room = turn_room(request_.obstacles.rover_at_rest, route_m[k],
                                      std::atan2(in_m.y(), in_m.x()), standing_.footprints());
      if (const auto thing = room.hindrance(std::atan2(out_m.y(), out_m.x()))) return thing;
    }
    return {};
  }

  std::string why_cut_off(GroundMap& map, const Reachability& reach) const {
    if (is_start_blocked_) {
      return "as it stands at the start it can drive neither forwards nor backwards, and it cannot "
             "turn on the spot";
    }
    if (turns_too_wide_)
      return "there is a route, but none was found with turns as wide as it needs";
    if (reach.answer == Reachability::Answer::start_enclosed) {
      const std::string at_start = fault_at(map, finder_, Vec2::Zero());
      if (!at_start.empty()) return fmt::format("no route leads on from the start, {}", at_start);
      const double goal_yaw_rad = std::atan2(goal_m_.y(), goal_m_.x());
      if (const auto thing = turn_room_.hindrance(goal_yaw_rad)) {
        return fmt::format("there is no room to turn beside '{}'", standing_.id(*thing));
      }
    }
    const Vec2 left_m = goal_m_ - reach.nearest_m;
    const double off_m = left_m.norm();
    const Vec2 ahead = left_m.normalized(), on_m = reach.nearest_m + ahead * 2 * spacing_m_;
    std::string beyond = fault_at(map, finder_, on_m);
    if (beyond.empty()) beyond = fault_ahead(map, finder_, on_m, ahead);
    if (beyond.empty()) beyond = "cut off";
    beyond = "ahead the ground is " + beyond;
    if (const auto thing = standing_.near(on_m, RouteCost::cross_track_margin_m + 2 * spacing_m_)) {
      beyond = fmt::format("'{}' stands in the way", standing_.id(*thing));
    }
    const std::string reported = fmt::format("{:.{}f}", off_m, off_m < 10 ? 1 : 0);
    if (reach.answer == Reachability::Answer::given_up) {
      return fmt::format(
          "no route was found among {:.1f} million places; the nearest that was "
          "reached is {:.0f} m from the goal, {}",
          static_cast<double>(reach.expanded) / 1e6, off_m, beyond);
    }
    return fmt::format("no route comes nearer to the goal than {} m; {}", reported, beyond);
  }

  // A rover that stands beyond a limit may leave over ground that is hardly worse.
  void find_leaving(GroundMap& map) {
    leaving_.radius_m = 0;
    const Stance stance = best_stance(map, finder_, Vec2::Zero());
    if (!stance.is_on_ground || hazard(stance, finder_.cost()) == Hazard::none) return;
    double reach_m = tight_m;
    for (const Vec2& wheel_B_m : finder_.cost().wheels_B_m) {
      reach_m = std::max(reach_m, leaving_reaches * wheel_B_m.norm());
    }
    leaving_ = {Vec2::Zero(), reach_m};
    leaving_limits_ = finder_.cost().limits;
    DriveLimits& limits = leaving_limits_;
    limits.slope_max_rad = std::max(limits.slope_max_rad, leaving_worse * stance.slope_rad);
    limits.unevenness_max_m =
        std::max(limits.unevenness_max_m, leaving_worse * stance.unevenness_m);
    limits.clearance_min_m =
        std::min(limits.clearance_min_m, stance.clearance_m - leaving_clearance_m);
  }

  // Distance between avoided places on a line; longer than the steps in which costs are summed.
  double step_m() const { return 1.6 * spacing_m_; }
  bool is_near_end(const Vec2& at_m) const {
    if (leaving_.holds(at_m)) return true;
    return std::min(at_m.norm(), (at_m - goal_m_).norm()) < tight_m + step_m();
  }

  // Both return the empty route where there is none.
  Stretches over_nodes(RouteCost& costs, Vec2& nearest_m) {
    const RouteSteering straight = RouteSteering::on_the_spot();
    const auto is_free = [&] {
      return std::isfinite(costs.along(straight.line(before_optimising_.front().poses)));
    };
    if (before_optimising_.empty() || !is_free()) {
      const GridRoute route = search_grid(costs, Vec2::Zero(), goal_m_);
      nearest_m = route.nearest_m;
      before_optimising_.clear();
      if (route.line.empty()) return {};
      before_optimising_.emplace_back();
      for (const Vec2& at_m : corners(route.line)) {
        before_optimising_.front().poses.push_back({at_m, 0});
      }
    }
    const std::vector<Pose2>& poses = before_optimising_.front().poses;
    OptimisedRoute best = optimise(costs, straight, poses, request_.seed);
    if (!std::isfinite(costs.along(best.line))) best.line = straight.line(poses);
    leg_.messages = std::move(best.messages);
    return {{poses, std::move(best.line), false}};
  }

  Stretches over_poses(RouteCost& costs, Vec2& nearest_m) {
    const Pose2 start{Vec2::Zero(), std::numbers::pi / 2 - request_.start_heading_rad};
    CarRoute found = car_route(costs, finder_.cost(), start, goal_m_, radius_m_, request_.seed,
                               poses_left_, before_optimising_);
    before_optimising_ = std::move(found.before_optimising);
    leg_.messages = std::move(found.messages);
    if (found.is_found()) return std::move(found.stretches);
    nearest_m = found.nearest_m;
    turns_too_wide_ = found.is_turn_too_wide;
    is_start_blocked_ = found.is_start_blocked;
    are_turns_at_border_ = found.is_at_border;
    return {};
  }

  void fill_result(GroundMap& map, RouteCost& costs, const Stretches& route) {
    const LegSummary reported = summary(costs, route);
    leg_.cost = reported.cost;
    leg_.length_m = reported.length_m;
    leg_.duration_s = reported.duration_s;
    leg_.energy_j = reported.energy_j;
    add_start(costs, route.front());
    leg_.slope_max_rad = reported.slope_max_rad;
    leg_.steepest_S_m = on_ground(map, probe_, reported.steepest_m);
    GearedLine whole = corners(route);
    for (const Vec2& at_m : whole.line) leg_.path_S_m.push_back(on_ground(map, probe_, at_m));
    leg_.gear_changes = std::move(whole.gear_changes);
    leg_.path_S_m.back() = request_.goal_S_m;
    const Vec3& goal_S_m = request_.goal_S_m;
    const Vec3 last_S_m = goal_S_m - leg_.path_S_m[leg_.path_S_m.size() - 2];
    leg_.end_heading_rad = ground_.site().azimuth_rad(last_S_m, goal_S_m);
    if (route.back().is_backward) {
      leg_.end_heading_rad =
          std::remainder(leg_.end_heading_rad + std::numbers::pi, 2 * std::numbers::pi);
    }
    if (goal_m_.norm() < same_point_m) leg_.end_heading_rad = request_.start_heading_rad;
  }

  // Adds setting off from rest; or the corner between the previous leg and this one, where the
  // previous leg is taken to end in a piece as long as the first of this one.
  void add_start(const RouteCost& costs, const Stretch& first) {
    const DriveCost& cost = finder_.cost();
    const Line2& line = first.line;
    // To begin backwards counts as a change of gear, which includes a stop. A leg does not know the
    // gear in which the one before it ended: where that was backwards this is taken to begin at
    // rest, and a change too many or too few is counted.
    if (request_.starts_at_rest && !first.is_backward) {
      leg_.energy_j += cost.stop_j;
      leg_.duration_s += cost.stop_s;
    }
    if (!cost.can_turn_on_spot || goal_m_.norm() < same_point_m) return;
    const Vec2 first_m = line[1] - line[0];
    const double heading_rad = request_.start_heading_rad;
    const Vec2 ahead(std::sin(heading_rad), std::cos(heading_rad));
    const double bend_rad = std::abs(lsos::bend_rad(ahead, first_m));
    const RouteCost::CornerCost turn =
        request_.starts_at_rest
            ? costs.turning(bend_rad)
            : costs.corner_cost(line[0] - first_m.norm() * ahead, line[0], line[1]);
    leg_.energy_j += turn.energy_j;
    leg_.duration_s += turn.duration_s;
  }

  void refuse_length() {
    const SiteFrame& site = ground_.site();
    const double length_m = surface_distance_m(site.body(), site.geodetic(request_.start_S_m),
                                               site.geodetic(request_.goal_S_m));
    leg_.reason = fmt::format(
        "it is {:.1f} km long; {:.1f} km at most can be planned at once in this direction, at "
        "{:.2f} m: waypoints between make shorter legs",
        std::ceil(length_m / 100) / 10, std::floor(longest_m() / 100) / 10, spacing_m_);
    leg_.nearest_S_m = request_.goal_S_m;
  }

  bool refuse(GroundMap& map, const std::string& reason, const Vec2& nearest_m) {
    leg_.reason = reason;
    leg_.messages.clear();
    leg_.nearest_S_m = on_ground(map, probe_, nearest_m);
    return true;
  }

  const Ground& ground_;
  const LegRequest& request_;
  StanceFinder finder_;
  MapFrame frame_;
  double spacing_m_, radius_m_;
  Vec2 goal_m_;
  std::vector<Disc2> avoided_;
  StandingObstacles standing_;
  TurnRoom turn_room_;
  Disc2 leaving_;
  DriveLimits leaving_limits_;
  bool turns_too_wide_ = false, are_turns_at_border_ = false, is_start_blocked_ = false;
  // Route of the last attempt before refinement: the next attempt, which avoids a little more,
  // begins with it.
  Stretches before_optimising_;
  std::size_t poses_left_ = leg_poses_max;  // that the searches may still expand
  Ground::Probe probe_;
  PlannedLeg leg_;
};

}  // namespace

PlannedLeg plan_leg(const Ground& ground, const DriveCost& cost, const LegRequest& request) {
  return LegPlanner(ground, cost, request).run();
}

}  // namespace lsos
