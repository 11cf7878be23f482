#include "mission/route_ahead.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "mission/event_sequence.h"

namespace lsos {

namespace {

double heading_from_to_rad(const SiteFrame& site, const Vec3& from_S_m, const Vec3& to_S_m) {
  const Vec3 way_S_m = to_S_m - from_S_m;
  return std::atan2(way_S_m.dot(site.east_S(from_S_m)), way_S_m.dot(site.north_S(from_S_m)));
}

// Goes through a rover's events and knows where it is, as far as the plan says that.
class Ahead {
 public:
  Ahead(const Ground& ground, RoverRoutes& routes, const LegStart& start)
      : ground_(ground),
        routes_(routes),
        place_S_m_(start.p_S_m),
        heading_rad_(start.heading_rad) {}

  // An event that drives as drawn, or nobody knows where to.
  void pass(const PlanEvent& event) {
    const Path3 waypoints_S_m = geometry_S_m(event.geometry, ground_);
    if (waypoints_S_m.empty()) {
      place_S_m_.reset();
      heading_rad_.reset();
    }
    for (const Vec3& to_S_m : waypoints_S_m) go_to(to_S_m);
  }

  // One that plans its way.
  void plan(const PlanEvent& event, const RouteSettings& settings) {
    bool is_first = true;
    std::int64_t waypoint = 0;
    for (const Vec3& goal_S_m : geometry_S_m(event.geometry, ground_)) {
      ++waypoint;
      if (is_first && place_S_m_ && RoverRoutes::is_passed(settings, *place_S_m_, goal_S_m)) {
        continue;
      }
      const bool is_at_rest = std::exchange(is_first, false);
      if (!place_S_m_ || (!heading_rad_ && !routes_.can_turn_on_spot())) {
        go_to(goal_S_m);
        continue;
      }
      const LegStart start{*place_S_m_, heading_rad_.value_or(0), is_at_rest};
      PlannedLeg leg = routes_.leg(settings, start, goal_S_m);
      go_to(goal_S_m);
      if (leg.is_found()) {
        heading_rad_ = leg.end_heading_rad;
      } else {
        add_fault(event, waypoint, goal_S_m, leg);
      }
      result_.legs.push_back({event.sequence, waypoint, start, goal_S_m, settings, std::move(leg)});
    }
  }

  void add_fault(Fault fault) { result_.faults.push_back(std::move(fault)); }
  RouteAhead take() { return std::move(result_); }

 private:
  // Straight.
  void go_to(const Vec3& to_S_m) {
    if (!place_S_m_) {
      heading_rad_.reset();
    } else if ((to_S_m - *place_S_m_).norm() > 0) {
      heading_rad_ = heading_from_to_rad(ground_.site(), *place_S_m_, to_S_m);
    }
    place_S_m_ = to_S_m;
  }

  void add_fault(const PlanEvent& event, std::int64_t waypoint, const Vec3& goal_S_m,
                 const PlannedLeg& leg) {
    const Severity severity =
        event.on_failure == OnFailure::stop ? Severity::error : Severity::warning;
    add_fault({severity,
               {event.place.file, event.geometry.line},
               fmt::format("{} '{}': {}", event.type, event.label,
                           RoverRoutes::no_way_text(ground_, waypoint, goal_S_m, leg))});
  }

  const Ground& ground_;
  RoverRoutes& routes_;
  std::optional<Vec3> place_S_m_;
  std::optional<double> heading_rad_;
  RouteAhead result_;
};

}  // namespace

RouteAhead plan_ahead(const RoverMachine& machine, const MissionInfo& mission,
                      double start_heading_rad, ScriptHost& host, const Ground& ground,
                      RoverRoutes& routes) {
  const Geodetic& start = machine.rover.start;
  const Vec3 start_S_m =
      ground.site().p_S_m({start.lon_rad, start.lat_rad, ground.elevation_m(start).value_or(0)});
  Ahead ahead(ground, routes, {start_S_m, start_heading_rad});
  for (const EventMachine& event : machine.events) {
    if (!event.event.is_enabled) continue;
    std::optional<RouteSettings> settings;
    try {
      settings =
          host.route_settings(event.event.type, {event.event.params, {}}, mission.start_time);
    } catch (const ScriptError& error) {
      ahead.add_fault(
          {Severity::error, event.event.place,
           fmt::format("{} '{}': {}", event.event.type, event.event.label, error.what())});
    }
    if (settings) {
      ahead.plan(event.event, *settings);
    } else if (event.declaration.drives) {
      ahead.pass(event.event);
    }
  }
  return ahead.take();
}

}  // namespace lsos
