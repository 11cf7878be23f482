#include "mission/routes/drawn_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/segment.h"
#include "mission/routes/drawn_leg.h"
#include "plan/field_reader.h"
#include "route/cost/standing_obstacles.h"
#include "route/cost/turn_room.h"
#include "route/map/ground_map.h"

namespace lsos {

namespace {

RouteSettings settings_of(const PlanEvent& event, const EventDeclaration& declaration) {
  const auto number = [&](NumberRole role) { return find_number(event.params, declaration, role); };
  RouteSettings settings;
  if (const double* speed_mps = number(NumberRole::drive_speed)) settings.speed_mps = *speed_mps;
  if (const double* radius_m = number(NumberRole::arrival_radius)) {
    settings.arrival_radius_m = *radius_m;
  }
  return settings;
}

class DrawnRoute {
 public:
  DrawnRoute(const PlanEvent& event, const EventDeclaration& declaration, RoverRoutes& routes,
             const Ground& ground)
      : event_(event),
        routes_(routes),
        ground_(ground),
        settings_(settings_of(event, declaration)),
        cost_(routes.cost(settings_)) {}

  std::vector<Fault> look(const Path3& waypoints_S_m, const ExpectedPose& start) {
    if (start.p_S_m && start.heading_rad && !waypoints_S_m.empty()) {
      find_turn(*start.p_S_m, *start.heading_rad, waypoints_S_m);
    }
    const auto is_passed = [&](const Vec3& to_S_m) {
      return RoverRoutes::is_passed(settings_, *start.p_S_m, to_S_m);
    };
    if (start.p_S_m && std::ranges::all_of(waypoints_S_m, is_passed)) {
      warn("leads nowhere: the rover is expected to stand at its end already");
    }
    std::optional<Vec3> before_S_m = start.p_S_m;
    for (std::size_t k = 0; k < waypoints_S_m.size(); ++k) {
      const Vec3& to_S_m = waypoints_S_m[k];
      if (before_S_m) add_findings(k + 1, *before_S_m, to_S_m);
      before_S_m = to_S_m;
    }
    if (!cost_.can_turn_on_spot && start.p_S_m) find_missed(waypoints_S_m, start);
    for (const auto& [finding, waypoint] : {no_ground_, occupied_, steep_}) {
      if (!finding) continue;
      const Geodetic place = ground_.site().geodetic(finding->p_S_m);
      warn(fmt::format("the line to waypoint {} {}, after {:.0f} m at {:.6f},{:.6f}", waypoint,
                       finding->what, finding->along_m, lon_deg(place), lat_deg(place)));
    }
    return std::move(warnings_);
  }

 private:
  struct Found {
    std::optional<DrawnFinding> finding;
    std::size_t waypoint = 0;  // number of the waypoint that the leg leads to, from 1
  };

  // Finds the obstacle that keeps a rover which turns on the spot from turning to the first
  // waypoint that it does not stand on.
  void find_turn(const Vec3& from_S_m, double heading_rad, const Path3& waypoints_S_m) {
    if (!cost_.can_turn_on_spot) return;
    const MapFrame frame(ground_.site(), from_S_m);
    for (std::size_t k = 0; k < waypoints_S_m.size(); ++k) {
      const Vec2 to_m = frame.at(waypoints_S_m[k]);
      if (RoverRoutes::is_passed(settings_, from_S_m, waypoints_S_m[k])) continue;
      const Obstacles obstacles = routes_.obstacles_about(from_S_m, waypoints_S_m[k]);
      const StandingObstacles standing(obstacles, frame);
      const TurnRoom room = turn_room(obstacles.rover_at_rest, Vec2::Zero(),
                                      std::numbers::pi / 2 - heading_rad, standing.footprints());
      if (const auto thing = room.hindrance(std::atan2(to_m.y(), to_m.x()))) {
        warn(fmt::format("there is no room to turn to waypoint {} beside '{}'", k + 1,
                         standing.id(*thing)));
      }
      return;
    }
  }

  void add_findings(std::size_t waypoint, const Vec3& from_S_m, const Vec3& to_S_m) {
    const DrawnLegFindings leg =
        examine_leg(ground_, cost_, routes_.obstacles_about(from_S_m, to_S_m), from_S_m, to_S_m);
    if (leg.no_ground && !no_ground_.finding) no_ground_ = {leg.no_ground, waypoint};
    if (leg.occupied && !occupied_.finding) occupied_ = {leg.occupied, waypoint};
    if (leg.steep && (!steep_.finding || leg.steep->beyond_rad > steep_.finding->beyond_rad)) {
      steep_ = {leg.steep, waypoint};
    }
  }

  // Finds the first waypoint that a rover which cannot turn on the spot misses by more than its
  // arrival radius.
  void find_missed(const Path3& waypoints_S_m, const ExpectedPose& start) {
    const MapFrame frame(ground_.site(), *start.p_S_m);
    Vec2 at_m = Vec2::Zero();
    std::optional<Vec2> ahead;
    if (start.heading_rad) {
      ahead = Vec2(std::sin(*start.heading_rad), std::cos(*start.heading_rad));
    }
    double before_m = 0;  // length of the previous leg; the first begins at rest
    for (std::size_t k = 0; k < waypoints_S_m.size(); ++k) {
      const Vec2 leg_m = frame.at(waypoints_S_m[k]) - at_m;
      if (leg_m.norm() <= settings_.arrival_radius_m) continue;
      const double missed_m =
          ahead ? miss_distance_m(*ahead, leg_m, cost_.turning_radius_min_m) : 0;
      if (missed_m > settings_.arrival_radius_m && !has_fillet_room(*ahead, leg_m, before_m)) {
        return warn(fmt::format(
            "waypoint {} lies inside the turning circle of the rover, {:.1f} m, when it comes "
            "there: it passes it by {:.1f} m or more, or makes a loop; PathPlanRoute plans the "
            "turn",
            k + 1, cost_.turning_radius_min_m, missed_m));
      }
      at_m += leg_m;
      ahead = leg_m.normalized();
      before_m = leg_m.norm();
    }
  }

  // Whether the corner has room for a fillet that begins before it (driving_line.h).
  bool has_fillet_room(const Vec2& ahead, const Vec2& leg_m, double before_m) const {
    const double bend = std::abs(bend_rad(ahead, leg_m.normalized()));
    return cost_.turning_radius_min_m * std::tan(bend / 2) <= std::min(before_m, leg_m.norm());
  }

  void warn(const std::string& what) {
    warnings_.push_back({Severity::warning,
                         {event_.place.file, event_.geometry.line},
                         fmt::format("{} '{}': {}", event_.type, event_.label, what)});
  }

  const PlanEvent& event_;
  RoverRoutes& routes_;
  const Ground& ground_;
  RouteSettings settings_;
  const DriveCost& cost_;
  Found no_ground_, occupied_, steep_;
  std::vector<Fault> warnings_;
};

}  // namespace

std::vector<Fault> drawn_route_warnings(const PlanEvent& event, const EventDeclaration& declaration,
                                        const Path3& waypoints_S_m, const ExpectedPose& start,
                                        RoverRoutes& routes, const Ground& ground) {
  return DrawnRoute(event, declaration, routes, ground).look(waypoints_S_m, start);
}

}  // namespace lsos
