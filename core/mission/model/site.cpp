#include "mission/model/site.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lsos {

std::unique_ptr<Ground> ground_at(const TerrainSpec& terrain, const Body& body,
                                  const Geodetic& site, std::uint64_t seed) {
  if (!terrain.planet.empty() && terrain.planet != body.name) {
    const bool is_of_beyond = terrain.beyond && terrain.beyond->names_planet;
    throw InputError(terrain.place, fmt::format("terrain {} lies on {}, the plan's Planet is {}",
                                                is_of_beyond ? terrain.beyond->name : terrain.name,
                                                terrain.planet, body.name));
  }
  const SiteFrame datum(body, {site.lon_rad, site.lat_rad, 0});
  const std::optional<double> elevation_m = Ground(terrain, datum, seed).elevation_m(site);
  if (!elevation_m) {
    throw InputError(
        terrain.place,
        fmt::format("terrain {} has no ground at {:.6f},{:.6f}, the site: where the first rover "
                    "starts, or SiteOrigin of MissionInfo",
                    terrain.name, lon_deg(site), lat_deg(site)));
  }
  return std::make_unique<Ground>(
      terrain, SiteFrame(body, {site.lon_rad, site.lat_rad, *elevation_m}), seed);
}

std::unique_ptr<Ground> drivable_ground_at(const TerrainSpec& terrain, const Body& body,
                                           const Geodetic& site, std::uint64_t seed) {
  std::unique_ptr<Ground> ground = ground_at(terrain, body, site, seed);
  if (const std::string slivers = ground->slivers(site); !slivers.empty()) {
    throw InputError(terrain.place, fmt::format("no rover can start at {:.6f},{:.6f}: {}",
                                                lon_deg(site), lat_deg(site), slivers));
  }
  return ground;
}

std::unique_ptr<Ground> mission_ground(const TerrainSpec& terrain, const Plan& plan) {
  const MissionInfo& mission = plan.mission;
  // Nothing need drive at a SiteOrigin.
  const auto ground = mission.site ? ground_at : drivable_ground_at;
  return ground(terrain, *mission.planet, site_of(plan), mission.seed);
}

Path3 on_ground_S_m(const std::vector<Geodetic>& points, const Ground& ground) {
  Path3 path;
  for (const Geodetic& point : points) {
    const double elevation_m = ground.elevation_m(point).value_or(0);
    path.push_back(ground.site().p_S_m({point.lon_rad, point.lat_rad, elevation_m}));
  }
  return path;
}

double default_heading_rad(const RoverMachine& machine, const SiteFrame& site) {
  constexpr double elsewhere_m = 0.1;
  const Vec3 from_S_m = site.p_S_m(machine.rover.start);
  for (const EventMachine& event : machine.events) {
    if (!event.declaration.drives || !event.event.is_enabled) continue;
    for (const Geodetic& point : event.event.geometry.points) {
      const Vec3 line_S_m = site.p_S_m({point.lon_rad, point.lat_rad, 0}) - from_S_m;
      const double east_m = line_S_m.dot(site.east_S(from_S_m));
      const double north_m = line_S_m.dot(site.north_S(from_S_m));
      if (std::hypot(east_m, north_m) < elsewhere_m) continue;
      const double heading = std::atan2(east_m, north_m);
      return heading < 0 ? heading + 2 * std::numbers::pi : heading;
    }
  }
  return 0;
}

std::string unknown_ground_text(std::int64_t waypoint, const Geodetic& point) {
  return fmt::format("waypoint {} ({:.6f},{:.6f}) is where the terrain is not known", waypoint,
                     lon_deg(point), lat_deg(point));
}

std::vector<Fault> site_faults(const RoverMachine& machine, const Ground& ground,
                               const std::function<bool(const PlanEvent&)>& plans_its_route) {
  std::vector<Fault> faults;
  const PlanRover& rover = machine.rover;
  if (!ground.elevation_m(rover.start)) {
    faults.push_back({Severity::error, rover.place,
                      fmt::format("Rover '{}': its start ({:.6f},{:.6f}) is where the terrain is "
                                  "not known",
                                  rover.id, lon_deg(rover.start), lat_deg(rover.start))});
  }
  if (const std::string slivers = ground.slivers(rover.start); !slivers.empty()) {
    faults.push_back({Severity::error, rover.place,
                      fmt::format("Rover '{}': no rover can start at {:.6f},{:.6f}: {}", rover.id,
                                  lon_deg(rover.start), lat_deg(rover.start), slivers)});
  }
  for (const EventMachine& event : machine.events) {
    if (!event.declaration.drives || !event.event.is_enabled) continue;
    const bool is_known_by_plan = plans_its_route(event.event);
    std::int64_t number = 0;
    for (const Geodetic& point : event.event.geometry.points) {
      ++number;
      const std::string slivers = ground.slivers(point);
      std::string text;
      if (!slivers.empty()) {
        text = fmt::format("no rover can drive to waypoint {} ({:.6f},{:.6f}): {}", number,
                           lon_deg(point), lat_deg(point), slivers);
      } else if (!is_known_by_plan && !ground.elevation_m(point)) {
        text = unknown_ground_text(number, point);
      }
      if (text.empty()) continue;
      faults.push_back({Severity::error,
                        {event.event.place.file, event.event.geometry.line},
                        fmt::format("{} '{}': {}", event.event.type, event.event.label, text)});
    }
  }
  return faults;
}

std::vector<Fault> coarse_ground(const RoverMachine& machine, const Ground& ground) {
  const auto drives = [](const EventMachine& event) {
    return event.event.is_enabled && event.declaration.drives;
  };
  if (std::ranges::none_of(machine.events, drives)) return {};
  const auto warning = [](const Place& place, const std::string& subject, const std::string& what) {
    return std::vector<Fault>{{Severity::warning, place, fmt::format("{}: {}", subject, what)}};
  };
  const Geodetic& start = machine.rover.start;
  if (ground.is_beyond(start)) {
    const bool is_mirrored = !ground.is_beyond({start.lon_rad, -start.lat_rad, 0});
    return warning(
        machine.rover.place, fmt::format("Rover '{}'", machine.rover.id),
        fmt::format("starts outside Terrain, on the ground of TerrainBeyond{}",
                    is_mirrored ? "; with the other sign its latitude would lie inside" : ""));
  }
  if (const std::string coarse = ground.coarseness(start); !coarse.empty()) {
    return warning(machine.rover.place, fmt::format("Rover '{}'", machine.rover.id), coarse);
  }
  for (const EventMachine& event : machine.events) {
    if (!drives(event)) continue;
    for (const Geodetic& point : event.event.geometry.points) {
      const std::string coarse = ground.coarseness(point);
      if (coarse.empty()) continue;
      return warning(event.event.place,
                     fmt::format("{} '{}': at {:.6f},{:.6f}", event.event.type, event.event.label,
                                 lon_deg(point), lat_deg(point)),
                     coarse);
    }
  }
  return {};
}

}  // namespace lsos
