#include "mission/routes/rover_routes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "mission/routes/drive_cost_model.h"
#include "mission/routes/follower_limits.h"
#include "planet/ellipsoid.h"
#include "route/route_planner.h"
#include "vehicle/footprint.h"
#include "vehicle/limb_stance.h"

namespace lsos {

namespace {

// A leg planned ahead fits a rover this near to its expected start and, if the rover cannot turn on
// the spot, with at most this difference in heading.
constexpr double expected_within_m = 5, expected_heading_rad = 0.35;
// A rover nearer than this to a leg's start stands on it.
constexpr double on_start_m = 0.5;
constexpr double passed_max_m = 1;  // the same as in PathFollower
// Key among an event's attempts that counts how often it has requested a route.
constexpr std::int64_t whole_route = 0;

}  // namespace

RoverRoutes::RoverRoutes(const VehicleConfig& vehicle, const GroundLimits& limits, double load_w,
                         const Ground& ground, PlannedLegs& legs)
    : config_(&vehicle),
      vehicle_(as_it_stands(vehicle)),
      hubs_B_m_(lsos::hubs_B_m(vehicle)),
      started_B_m_(hubs_B_m_),
      limits_(limits),
      load_w_(load_w),
      ground_(&ground),
      legs_(&legs) {}

void RoverRoutes::stand_on(const std::vector<Vec3>& hubs_B_m) {
  if (hubs_B_m == hubs_B_m_) return;
  VehicleConfig standing = *config_;
  stand(standing, hubs_B_m);
  vehicle_ = as_it_stands(standing);
  hubs_B_m_ = hubs_B_m;
  costs_.clear();
}

bool RoverRoutes::stand_in(const std::string& stance) {
  const auto found = std::ranges::find(config_->stances, stance, &LimbStance::name);
  if (found == config_->stances.end()) return false;
  stand_on(found->hubs_B_m);
  return true;
}

void RoverRoutes::stand_as_started() { stand_on(started_B_m_); }

void RoverRoutes::start_on(const std::vector<Vec3>& hubs_B_m) {
  stand_on(hubs_B_m);
  started_B_m_ = hubs_B_m;
}

const DriveCost& RoverRoutes::cost(const RouteSettings& settings) {
  const double speed_mps =
      std::min(settings.speed_mps.value_or(vehicle_.cruise_speed_mps), vehicle_.speed_max_mps);
  const double slope_max_rad =
      settings.slope_max_rad.value_or(std::numeric_limits<double>::infinity());
  const auto known = costs_.find({speed_mps, slope_max_rad});
  if (known != costs_.end()) return known->second;
  const SiteFrame& site = ground_->site();
  DriveCost cost = drive_cost(vehicle_, ground_->soils(), gravity_mps2(site.body(), site.origin()),
                              speed_mps, limits_);
  cost.load_w = load_w_;
  cost.limits.slope_max_rad = std::min(cost.limits.slope_max_rad, slope_max_rad);
  return costs_.emplace(std::pair(speed_mps, slope_max_rad), std::move(cost)).first->second;
}

PlannedLeg RoverRoutes::leg(const RouteSettings& settings, const LegStart& start,
                            const Vec3& goal_S_m) {
  LegRequest request;
  request.start_S_m = start.p_S_m;
  request.goal_S_m = goal_S_m;
  request.aim = settings.aim;
  request.avoided = settings.avoided;
  request.starts_at_rest = start.is_at_rest;
  request.start_heading_rad = start.heading_rad;
  request.obstacles = obstacles_about(start.p_S_m, goal_S_m);
  std::ranges::copy(settings.standing, std::back_inserter(request.obstacles.standing));
  const PlannedLeg& whole = legs_->leg(cost(settings), request);
  const Vec3 nearest_S_m = whole.nearest_S_m;
  const bool is_near = nearest_S_m != goal_S_m &&
                       (nearest_S_m - goal_S_m).norm() <= settings.arrival_radius_m &&
                       (nearest_S_m - start.p_S_m).norm() > on_start_m;
  if (whole.is_found() || !is_near) return whole;
  request.goal_S_m = nearest_S_m;
  PlannedLeg shorter = legs_->leg(cost(settings), request);
  if (!shorter.is_found()) return whole;
  // A rover that drives down a wall which it cannot climb would be lost there.
  request.start_S_m = nearest_S_m;
  request.goal_S_m = start.p_S_m;
  request.start_heading_rad = shorter.end_heading_rad;
  request.starts_at_rest = true;
  if (!legs_->leg(cost(settings), request).is_found()) return whole;
  shorter.reason = whole.reason;
  return shorter;
}

Obstacles RoverRoutes::obstacles_about(const Vec3& start_S_m, const Vec3& goal_S_m) const {
  // The reach goes beyond the widest map that a leg is planned on.
  constexpr double lengths = 4, least_m = 200;
  const double reach_m = least_m + lengths * (goal_S_m - start_S_m).norm();
  Obstacles obstacles;
  obstacles.rover_at_rest = footprint_at_rest(vehicle_);
  for (const Obstacle& thing : legs_->standing()) {
    if ((thing.center_S_m - start_S_m).norm() < reach_m) obstacles.standing.push_back(thing);
  }
  return obstacles;
}

bool RoverRoutes::is_passed(const RouteSettings& settings, const Vec3& p_S_m,
                            const Vec3& waypoint_S_m) {
  return (waypoint_S_m - p_S_m).norm() <= std::min(settings.arrival_radius_m, passed_max_m);
}

std::string RoverRoutes::no_route_text(const Ground& ground, std::int64_t waypoint,
                                       const Vec3& start_S_m, const Vec3& goal_S_m,
                                       const PlannedLeg& leg) {
  // Distances are along the body's surface, as on maps.
  const auto off_m = [&](const Vec3& p_S_m) {
    return surface_distance_m(ground.site().body(), ground.site().geodetic(p_S_m),
                              ground.site().geodetic(goal_S_m));
  };
  if (leg.nearest_S_m == goal_S_m) {
    return fmt::format("the leg to waypoint {}: {}", waypoint, leg.reason);
  }
  if ((leg.nearest_S_m - start_S_m).norm() < on_start_m) {
    return fmt::format(
        "the leg to waypoint {}: {}; no place nearer to it than the start can be reached, {:.0f} m "
        "from it",
        waypoint, leg.reason, off_m(start_S_m));
  }
  const Geodetic nearest = ground.site().geodetic(leg.nearest_S_m);
  // Rounding first turns tiny negative angles into -0, and adding 0 turns -0 into 0.
  const auto rounded_deg = [](double angle_deg) { return std::round(angle_deg * 1e6) / 1e6 + 0.0; };
  return fmt::format(
      "the leg to waypoint {}: {}; the nearest place that can be reached is {:.6f},{:.6f}, "
      "{:.0f} m from it",
      waypoint, leg.reason, rounded_deg(lon_deg(nearest)), rounded_deg(lat_deg(nearest)),
      off_m(leg.nearest_S_m));
}

std::string RoverRoutes::short_end_text(std::int64_t waypoint, const Vec3& goal_S_m,
                                        const PlannedLeg& leg) {
  return fmt::format("the leg to waypoint {} ends {:.1f} m from it, within ArrivalRadius: {}",
                     waypoint, (goal_S_m - leg.path_S_m.back()).norm(), leg.reason);
}

void RoverRoutes::log_ahead(const std::string& rover_id, SimTime now,
                            const std::set<std::int64_t>* sequences) {
  if (ahead_ == nullptr) return;
  for (const LegAhead& ahead : *ahead_) {
    if (sequences != nullptr && !sequences->contains(ahead.sequence)) continue;
    if (ahead.leg.is_found()) log(rover_id, now, ahead.sequence, ahead.waypoint, ahead.leg);
  }
}

const LegAhead* RoverRoutes::ahead(std::int64_t sequence, std::int64_t waypoint,
                                   const LegStart& start, const Vec3& goal_S_m,
                                   const RouteSettings& settings) {
  if (ahead_ == nullptr) return nullptr;
  const auto found = std::ranges::find_if(*ahead_, [&](const LegAhead& a) {
    return a.sequence == sequence && a.waypoint == waypoint && a.goal_S_m == goal_S_m &&
           a.settings == settings && a.hubs_B_m == hubs_B_m_;
  });
  if (found == ahead_->end()) return nullptr;
  const double off_m = (start.p_S_m - found->start.p_S_m).norm();
  const double off_rad =
      std::remainder(start.heading_rad - found->start.heading_rad, 2 * std::numbers::pi);
  // Where the rover backs up, arcs are short and there is no room to come to them from elsewhere.
  const double within_m = found->leg.gear_changes.empty() ? expected_within_m : on_start_m;
  const bool fits =
      off_m <= within_m &&
      (vehicle_.can_turn_on_spot || std::abs(off_rad) <= expected_heading_rad) &&
      (off_m <= on_start_m || !found->leg.is_found() ||
       is_free(*ground_, cost(settings), obstacles_about(start.p_S_m, found->start.p_S_m),
               start.p_S_m, found->start.p_S_m));
  return fits ? &*found : nullptr;
}

PlannedRoute RoverRoutes::plan(const std::string& rover_id, SimTime now, std::int64_t sequence,
                               const LegStart& start, const Path3& waypoints_S_m,
                               std::int64_t first, const RouteSettings& settings) {
  PlannedRoute way;
  LegStart at = start;
  const auto count = static_cast<std::int64_t>(waypoints_S_m.size());
  // A second request means that the rover is stuck or off its line: the route begins where it is.
  const bool is_replanning = attempts_[sequence][whole_route]++ > 0;
  for (std::int64_t waypoint = first; waypoint <= count; ++waypoint) {
    const Vec3& goal_S_m = waypoints_S_m[static_cast<std::size_t>(waypoint - 1)];
    if (way.legs.empty() && is_passed(settings, at.p_S_m, goal_S_m)) continue;
    const bool is_from_here = is_replanning && way.legs.empty();
    const LegAhead* known =
        is_from_here ? nullptr : ahead(sequence, waypoint, at, goal_S_m, settings);
    const PlannedLeg planned = known != nullptr ? known->leg : leg(settings, at, goal_S_m);
    if (known == nullptr && planned.is_found()) log(rover_id, now, sequence, waypoint, planned);
    for (const std::string& message : planned.messages) {
      warnings_.push_back(
          fmt::format("{}: planning the leg to waypoint {}: {}", rover_id, waypoint, message));
    }
    if (!planned.is_found()) {
      PlannedRoute none;
      none.reason = no_route_text(*ground_, waypoint, at.p_S_m, goal_S_m, planned);
      if (planned.nearest_S_m != goal_S_m) none.nearest_S_m = planned.nearest_S_m;
      return none;
    }
    if (known == nullptr && planned.ends_short()) {
      warnings_.push_back(
          fmt::format("{}: {}", rover_id, short_end_text(waypoint, goal_S_m, planned)));
    }
    // Each leg begins at the last point of the one before, in a gear of its own.
    const std::size_t joint = way.path_S_m.empty() ? 0 : way.path_S_m.size() - 1;
    const bool was_backward = way.gear_changes.size() % 2 == 1;
    if (was_backward && !planned.begins_backwards()) way.gear_changes.push_back(joint);
    for (const std::size_t at_point : planned.gear_changes) {
      if (at_point > 0 || !was_backward) way.gear_changes.push_back(joint + at_point);
    }
    way.path_S_m.insert(way.path_S_m.end(), planned.path_S_m.begin() + (way.legs.empty() ? 0 : 1),
                        planned.path_S_m.end());
    way.legs.push_back({waypoint, way.path_S_m.size() - 1, planned.length_m, planned.duration_s,
                        planned.energy_j, planned.slope_max_rad});
    at = {planned.ends_short() ? planned.path_S_m.back() : goal_S_m, planned.end_heading_rad,
          planned.ends_backwards()};
  }
  // The rover already stands at its goal.
  if (way.legs.empty()) way.path_S_m = {waypoints_S_m.back()};
  last_ = way;
  return way;
}

DriveEstimate RoverRoutes::estimate(const Vec3& from_S_m, double yaw_rad, const Path3& path_S_m,
                                    const FollowSettings& settings) {
  RouteSettings route;
  route.speed_mps = settings.speed_mps;
  if (path_S_m == last_.path_S_m) {
    route.slope_max_rad = settings.slope_max_rad;
    return estimate_planned(cost(route), from_S_m, last_, settings);
  }
  const DriveCost& driven = cost(route);
  return estimate_drawn(*ground_, driven,
                        limits_of(vehicle_, driven.speed_mps, driven.gravity_mps2), from_S_m,
                        yaw_rad, path_S_m, settings);
}

void RoverRoutes::log(const std::string& rover_id, SimTime now, std::int64_t sequence,
                      std::int64_t waypoint, const PlannedLeg& leg) {
  PlannedPathRow row;
  row.time = now;
  row.rover_id = rover_id;
  row.sequence = sequence;
  row.leg = waypoint;
  row.attempt = attempts_[sequence][waypoint]++;
  row.length_m = leg.length_m;
  row.duration_s = leg.duration_s;
  row.energy_j = leg.energy_j;
  row.slope_max_rad = leg.slope_max_rad;
  row.steepest = ground_->site().geodetic(leg.steepest_S_m);
  for (const Vec3& p_S_m : leg.path_S_m) row.line.push_back(ground_->site().geodetic(p_S_m));
  rows_.push_back(std::move(row));
}

std::vector<PlannedPathRow> RoverRoutes::take_rows() { return std::exchange(rows_, {}); }
std::vector<std::string> RoverRoutes::take_warnings() { return std::exchange(warnings_, {}); }

}  // namespace lsos
