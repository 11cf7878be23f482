#include "mission/ahead/ground_end_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mission/ahead/expected_time.h"
#include "mission/light/sight_over_end.h"
#include "planet/sky.h"
#include "planet/sunlight.h"

namespace lsos {

namespace {

constexpr double eye_height_m = 2;
constexpr int times = 24;
constexpr std::size_t stops_max = 32;

struct Stop {
  std::string rover_id, name;
  Vec3 eye_S_m;
};

std::vector<Stop> stops_of(const MissionMachine& machine, const Ground& ground) {
  std::vector<Stop> all;
  const auto add = [&](const std::string& rover_id, const std::string& name,
                       const Geodetic& place) {
    const auto height_m = ground.elevation_m(place);
    if (!height_m) return;
    all.push_back({rover_id, name,
                   ground.site().p_S_m({place.lon_rad, place.lat_rad, *height_m + eye_height_m})});
  };
  for (const RoverMachine& rover : machine.rovers) {
    add(rover.rover.id, "the start", rover.rover.start);
    for (const EventMachine& event : rover.events) {
      if (!event.event.is_enabled || event.event.geometry.points.empty()) continue;
      add(rover.rover.id, fmt::format("'{}'", event.event.label),
          event.event.geometry.points.back());
    }
  }
  if (all.size() <= stops_max) return all;
  std::vector<Stop> some;
  for (std::size_t k = 0; k < stops_max; ++k) some.push_back(all[k * all.size() / stops_max]);
  return some;
}

struct Worst {
  std::optional<GroundEnd> end;
  const Stop* stop = nullptr;
  Instant at;
  double elevation_rad = 0;
};

std::optional<Fault> worst_fault(const Worst& worst, const std::string& seen, const Place& place) {
  if (!worst.end) return {};
  return Fault{Severity::warning, place,
               fmt::format("MissionInfo: at {} of {}, about {}, {}; what is seen there is seen "
                           "over the known ground alone; TerrainBeyond lays a coarser terrain "
                           "around it",
                           worst.stop->name, worst.stop->rover_id, format_utc(worst.at),
                           end_text(*worst.end, seen, worst.elevation_rad))};
}

// Estimated duration of the plan's events: that of the rover that takes longest, at most
// MaxDuration.
SimTime estimated_duration(const MissionMachine& machine,
                           const std::map<std::string, RoverModel>& models, const Body& body) {
  SimTime longest{};
  for (const RoverMachine& rover : machine.rovers) {
    SimTime now{};
    Geodetic at = rover.rover.start;
    const VehicleConfig& vehicle = models.at(rover.rover.model()).spec.vehicle;
    for (const EventMachine& event : rover.events) {
      if (event.event.is_enabled && !event.event.at) {
        now = expected_end(event, vehicle, now, machine.mission.start_time, body, at);
      }
    }
    longest = std::max(longest, now);
  }
  return std::min(longest, machine.mission.max_duration);
}

}  // namespace

std::vector<Fault> ground_end_warnings(const MissionMachine& machine,
                                       const std::map<std::string, RoverModel>& models,
                                       const Ground& ground, bool watches_sun) {
  if (!ground.has_end()) return {};
  const SiteFrame& site = ground.site();
  const Body& body = site.body();
  const std::vector<Stop> stops = stops_of(machine, ground);
  const SimTime duration = estimated_duration(machine, models, body);
  GroundEndProbe probe(ground);
  Worst of_sun, of_earth;
  const auto look = [&](const Stop& stop, Instant at, const Vec3& direction_S, double disc_rad,
                        Worst& worst) {
    const auto end = probe.towards(stop.eye_S_m, direction_S, disc_rad);
    if (!end || (worst.end && end->matters_m <= worst.end->matters_m)) return;
    const double sine = std::clamp(direction_S.dot(site.up_S(stop.eye_S_m)), -1.0, 1.0);
    worst = {end, &stop, at, std::asin(sine)};
  };
  for (int k = 0; k <= times; ++k) {
    const Instant at = machine.mission.start_time + duration * k / times;
    for (const Stop& stop : stops) {
      if (watches_sun) {
        const Sunlight sun = sunlight(body, site.geodetic(stop.eye_S_m), at, 0);
        look(stop, at, direction_S(site, stop.eye_S_m, sun.seen), sun.disc_rad, of_sun);
      }
      if (body.id == BodyId::earth) continue;
      const Sighting earth = sighting(body, site.p_F_m(stop.eye_S_m), CelestialBody::earth, at);
      look(stop, at, site.R_FS().transpose() * earth.direction_F, earth.disc_rad, of_earth);
    }
  }
  std::vector<Fault> faults;
  for (const auto& fault : {worst_fault(of_sun, "the Sun", machine.mission.place),
                            worst_fault(of_earth, "Earth", machine.mission.place)}) {
    if (fault) faults.push_back(*fault);
  }
  return faults;
}

}  // namespace lsos
