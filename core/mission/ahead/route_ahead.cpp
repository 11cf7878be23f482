#include "mission/ahead/route_ahead.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/polygon.h"
#include "mission/model/foreseen.h"
#include "mission/model/site.h"
#include "mission/routes/drawn_route.h"
#include "plan/field_reader.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// In both units that speeds are written in.
std::string speed_text(double speed_mps) {
  return fmt::format("{:.3g} m/s ({:.3g} km/h)", speed_mps, 3.6 * speed_mps);
}

// Heading at the end of the line; near a pole the direction of north changes along it.
double heading_from_to_rad(const SiteFrame& site, const Vec3& from_S_m, const Vec3& to_S_m) {
  return site.azimuth_rad(to_S_m - from_S_m, to_S_m);
}

// Warning about an area without ground; "" when a grid of samples finds ground throughout.
std::string area_warning(const PlanGeometry& geometry, const Path3& outline_S_m,
                         const Ground& ground) {
  constexpr int places_a_side = 40;
  Ring outline;
  Vec2 low_m = outline_S_m.front().head<2>(), high_m = low_m;
  for (const Vec3& corner_S_m : outline_S_m) {
    outline.emplace_back(corner_S_m.head<2>());
    low_m = low_m.cwiseMin(outline.back());
    high_m = high_m.cwiseMax(outline.back());
  }
  std::vector<Ring> holes;
  for (const std::vector<Geodetic>& hole : geometry.holes) {
    Ring& ring = holes.emplace_back();
    for (const Geodetic& corner : hole) ring.emplace_back(ground.site().p_S_m(corner).head<2>());
  }
  int places = 0, missing = 0;
  Geodetic first;
  for (int row = 0; row < places_a_side; ++row) {
    for (int column = 0; column < places_a_side; ++column) {
      const Vec2 share((column + 0.5) / places_a_side, (row + 0.5) / places_a_side);
      const Vec2 at_m = low_m + share.cwiseProduct(high_m - low_m);
      const auto is_in = [&](const Ring& ring) { return contains(ring, at_m); };
      if (!is_in(outline) || std::ranges::any_of(holes, is_in)) continue;
      ++places;
      const Geodetic place = ground.site().geodetic({at_m.x(), at_m.y(), 0});
      if (ground.elevation_m(place)) continue;
      if (missing++ == 0) first = place;
    }
  }
  if (missing == 0) return "";
  return fmt::format("{:.0f} % of its area has no ground, as at {:.6f},{:.6f}",
                     std::ceil(100.0 * missing / places), lon_deg(first), lat_deg(first));
}

// Whether the rover comes to the event in turn; others are done at their times, or not at all.
bool is_passed_through(const EventMachine& event) {
  return event.event.is_enabled && !event.event.at;
}

// Goes through a rover's events and tracks its position, as far as the plan determines it.
class RoutePass {
 public:
  RoutePass(const Ground& ground, RoverRoutes& routes, const LegStart& start,
            const std::function<void(const std::string&)>& on_planning)
      : ground_(ground),
        routes_(routes),
        on_planning_(on_planning),
        place_S_m_(start.p_S_m),
        heading_rad_(start.heading_rad) {}

  // Follows a change of the rover's stance, after which it is another vehicle to plan for: which
  // stance is known when the event names it.
  void change_stance(const PlanEvent& event, const EventDeclaration& declaration) {
    const bool changes = std::ranges::any_of(declaration.fields, [](const FieldDeclaration& field) {
      return field.names == NameOf::stance;
    });
    if (!changes) return;
    const std::string* stance = find_name(event.params, declaration, NameOf::stance);
    is_stance_known_ = stance != nullptr && routes_.stand_in(*stance);
  }

  // Handles an event that drives as drawn, or to an unknown place.
  void pass(const PlanEvent& event, const EventDeclaration& declaration) {
    const Path3 waypoints_S_m = on_ground_S_m(event.geometry.points, ground_);
    const bool is_anywhere = waypoints_S_m.empty() || event.geometry.kind == GeometryKind::polygon;
    if (event.geometry.kind == GeometryKind::polygon) {
      if (const std::string text = area_warning(event.geometry, waypoints_S_m, ground_);
          !text.empty()) {
        add_fault({Severity::warning,
                   {event.place.file, event.geometry.line},
                   fmt::format("{} '{}': {}", event.type, event.label, text)});
      }
    }
    if (is_anywhere) {
      place_S_m_.reset();
      heading_rad_.reset();
      return;
    }
    for (Fault& warning : drawn_route_warnings(event, declaration, waypoints_S_m,
                                               {place_S_m_, heading_rad_}, routes_, ground_)) {
      add_fault(std::move(warning));
    }
    add_line(event, waypoints_S_m);
    for (const Vec3& to_S_m : waypoints_S_m) go_to(to_S_m);
  }

  // Warns about an event that takes power from an asset beyond the reach of the cable.
  void find_cable(const PlanEvent& event, const EventDeclaration& declaration,
                  std::span<const PowerSource> sources) {
    if (declaration.drives) near_.reset();
    for (const FieldDeclaration& field : declaration.fields) {
      const auto* id = field.names == NameOf::power_source
                           ? find_value<std::string>(event.params, field.key)
                           : nullptr;
      if (id == nullptr) continue;
      if (near_ && near_->id == *id && near_->distance_m > cable_reach_m) {
        add_fault({Severity::warning, event.place,
                   fmt::format("{} '{}': {} = {}: '{}' drives to within {:.0f} m of it only; a "
                               "cable reaches {:.0f} m",
                               event.type, event.label, field.name, quoted(*id), near_->label,
                               near_->distance_m, cable_reach_m)});
      }
      if (!place_S_m_) continue;
      const auto source = std::ranges::find(sources, *id, &PowerSource::asset_id);
      if (source == sources.end()) continue;
      const double away_m = (source->p_S_m - *place_S_m_).norm();
      if (away_m <= cable_reach_m) continue;
      add_fault({Severity::warning, event.place,
                 fmt::format("{} '{}': {} = {}: it is {:.0f} m from where rover {} then is "
                             "expected; a cable reaches {:.0f} m",
                             event.type, event.label, field.name, quoted(*id), away_m,
                             quoted(event.rover_id), cable_reach_m)});
    }
  }

  // Records what an event drives towards until it is near.
  void find_near(const PlanEvent& event, const EventDeclaration& declaration) {
    if (!declaration.drives || !event.geometry.points.empty()) return;
    const std::string* id = find_name(event.params, declaration, NameOf::other);
    const double* distance_m = find_number(event.params, declaration, NumberRole::arrival_radius);
    if (id != nullptr && distance_m != nullptr) near_ = {*id, event.label, *distance_m};
  }

  // Plans the route of an event; returns false when there is none: the event fails before it
  // drives.
  bool plan(const PlanEvent& event, const RouteSettings& settings) {
    const std::optional<Vec3> start_S_m = place_S_m_;
    const std::optional<double> start_heading_rad = heading_rad_;
    bool is_first = true, backed_up = false;
    std::int64_t waypoint = 0;
    if (!is_stance_known_) {
      add_fault({Severity::warning, event.place,
                 fmt::format("{} '{}': its route is planned when its turn comes: before it is not "
                             "known how the rover then stands on its limbs",
                             event.type, event.label)});
    }
    for (const Vec3& goal_S_m : on_ground_S_m(event.geometry.points, ground_)) {
      const Geodetic& point = event.geometry.points[static_cast<std::size_t>(waypoint++)];
      if (is_first && place_S_m_ && RoverRoutes::is_passed(settings, *place_S_m_, goal_S_m)) {
        result_.passed.push_back({event.sequence, waypoint});
        continue;
      }
      // It also stops where it has backed up.
      const bool is_at_rest = std::exchange(is_first, false) || backed_up;
      const bool is_heading_known = heading_rad_ || routes_.can_turn_on_spot();
      if (!place_S_m_ || !is_heading_known || !is_stance_known_) {
        if (!ground_.elevation_m(point)) add_fault(event, unknown_ground_text(waypoint, point));
        go_to(goal_S_m);
        continue;
      }
      const double heading_rad =
          heading_rad_.value_or(heading_from_to_rad(ground_.site(), *place_S_m_, goal_S_m));
      const LegStart start{*place_S_m_, heading_rad, is_at_rest};
      report_planning(fmt::format("{} '{}' to waypoint {}", event.rover_id, event.label, waypoint));
      PlannedLeg leg = routes_.leg(settings, start, goal_S_m);
      report_planning("");
      const bool is_found = leg.is_found();
      const Vec3 end_S_m = leg.ends_short() ? leg.path_S_m.back() : goal_S_m;
      if (!is_found) {
        add_fault(event, RoverRoutes::no_route_text(ground_, waypoint, start.p_S_m, goal_S_m, leg));
      } else if (leg.ends_short()) {
        add_fault({Severity::warning, event.place,
                   fmt::format("{} '{}': {}", event.type, event.label,
                               RoverRoutes::short_end_text(waypoint, goal_S_m, leg))});
      }
      result_.legs.push_back({event.sequence, waypoint, start, goal_S_m, settings, std::move(leg),
                              routes_.hubs_B_m()});
      if (!is_found) {
        place_S_m_ = start_S_m;
        heading_rad_ = start_heading_rad;
        return false;
      }
      go_to(end_S_m);
      heading_rad_ = result_.legs.back().leg.end_heading_rad;
      backed_up = result_.legs.back().leg.ends_backwards();
    }
    return true;
  }

  void warn_of_speed(const PlanEvent& event, const EventDeclaration& declaration) {
    const double* speed_mps = find_number(event.params, declaration, NumberRole::drive_speed);
    if (speed_mps == nullptr || *speed_mps <= routes_.speed_max_mps()) return;
    add_fault({Severity::warning, event.place,
               fmt::format("{} '{}': Speed is {}, a {} does {} at most", event.type, event.label,
                           speed_text(*speed_mps), routes_.rover_type(),
                           speed_text(routes_.speed_max_mps()))});
  }

  void add_fault(Fault fault) { result_.faults.push_back(std::move(fault)); }
  RouteAhead take() {
    routes_.stand_as_started();
    return std::move(result_);
  }

 private:
  void add_line(const PlanEvent& event, const Path3& waypoints_S_m) {
    DrawnLine line{event.sequence, {}, 0};
    if (place_S_m_) line.to_first_m = (waypoints_S_m.front() - *place_S_m_).norm();
    for (std::size_t k = 1; k < waypoints_S_m.size(); ++k) {
      line.along_m += (waypoints_S_m[k] - waypoints_S_m[k - 1]).norm();
    }
    result_.drawn.push_back(line);
  }

  // Moves the expected position straight to a place.
  void go_to(const Vec3& to_S_m) {
    if (!place_S_m_) {
      heading_rad_.reset();
    } else if ((to_S_m - *place_S_m_).norm() > 0) {
      heading_rad_ = heading_from_to_rad(ground_.site(), *place_S_m_, to_S_m);
    }
    place_S_m_ = to_S_m;
  }

  void report_planning(const std::string& what) const {
    if (on_planning_) on_planning_(what);
  }

  void add_fault(const PlanEvent& event, const std::string& what) {
    add_fault(foreseen_failure(event, what, event.geometry.line));
  }

  const Ground& ground_;
  RoverRoutes& routes_;
  const std::function<void(const std::string&)>& on_planning_;
  std::optional<Vec3> place_S_m_;
  std::optional<double> heading_rad_;
  bool is_stance_known_ = true;
  // The rover or asset that the last drive ended near, if the event named one.
  struct Near {
    std::string id, label;
    double distance_m = 0;
  };
  std::optional<Near> near_;
  RouteAhead result_;
};

}  // namespace

AskedRoutes asked_routes(const RoverMachine& machine, const MissionInfo& mission, ScriptHost& host,
                         std::vector<Fault>& faults) {
  AskedRoutes asked;
  for (const EventMachine& event : machine.events) {
    asked.emplace_back();
    if (!is_passed_through(event)) continue;
    try {
      asked.back() =
          host.route_settings(event.event.type, {event.event.params, {}}, mission.start_time);
    } catch (const ScriptError& error) {
      faults.push_back(
          {Severity::error, event.event.place,
           fmt::format("{} '{}': {}", event.event.type, event.event.label, error.what())});
    }
  }
  return asked;
}

RouteAhead plan_ahead(const RoverMachine& machine, const AskedRoutes& asked,
                      double start_heading_rad, const Ground& ground, RoverRoutes& routes,
                      std::span<const PowerSource> sources,
                      const std::function<void(const std::string& what)>& on_planning) {
  const Geodetic& start = machine.rover.start;
  const Vec3 start_S_m =
      ground.site().p_S_m({start.lon_rad, start.lat_rad, ground.elevation_m(start).value_or(0)});
  RoutePass ahead(ground, routes, {start_S_m, start_heading_rad}, on_planning);
  std::optional<std::int64_t> gone_to;  // sequence at which the rover goes on after a failure
  for (std::size_t k = 0; k < machine.events.size(); ++k) {
    const EventMachine& event = machine.events[k];
    if (!is_passed_through(event)) continue;
    if (gone_to && event.event.sequence < *gone_to) continue;
    ahead.warn_of_speed(event.event, event.declaration);
    ahead.change_stance(event.event, event.declaration);
    ahead.find_cable(event.event, event.declaration, sources);
    if (asked[k]) {
      if (ahead.plan(event.event, *asked[k])) continue;
      const OnFailure next = event.event.on_failure;
      if (next == OnFailure::stop || next == OnFailure::abort) break;
      if (next == OnFailure::go_to) gone_to = event.event.go_to_sequence;
    } else if (event.declaration.drives) {
      ahead.pass(event.event, event.declaration);
      ahead.find_near(event.event, event.declaration);
    }
  }
  return ahead.take();
}

}  // namespace lsos
