#include "mission/model/mission_span.h"

#include <algorithm>
#include <cmath>

#include "plan/field_reader.h"

namespace lsos {

namespace {

constexpr double hour_s = 3600, day_s = 24 * hour_s;
constexpr double detour_factor = 3;  // driven length over drawn length

// Speed of the drive, m/s: as its field requests, at most what the rover can do.
double speed_mps(const PlanEvent& event, const VehicleConfig& rover) {
  const double* requested_mps = find_value<double>(event.params, "speed_mps");
  return std::min(requested_mps == nullptr ? rover.cruise_speed_mps : *requested_mps,
                  rover.speed_max_mps);
}

// Length from the expected place of the rover through the drawn points. `at` becomes the last
// point.
double drawn_m(const Body& body, const PlanGeometry& geometry, Geodetic& at) {
  double length_m = 0;
  for (const Geodetic& point : geometry.points) {
    length_m += surface_distance_m(body, at, point);
    at = point;
  }
  return length_m;
}

}  // namespace

SimTime default_max_duration(const Plan& plan, const Declarations& declarations,
                             const std::map<std::string, RoverModel>& rovers,
                             const std::function<bool(const PlanEvent&)>& is_open_ended) {
  double latest_s = 0, sum_s = 0;
  const auto count_time = [&](Instant time) {
    latest_s = std::max(latest_s, seconds(time - plan.mission.start_time));
  };
  std::map<std::string, Geodetic> at;  // key: rover
  for (const PlanRover& rover : plan.rovers) at[rover.id] = rover.start;
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled) continue;
    const bool has_condition = !event.start_when.text.empty() || !event.stop_when.text.empty();
    if (has_condition || is_open_ended(event)) return longest_mission;
    if (event.start_time) count_time(*event.start_time);
    const EventDeclaration& declaration = declarations.events.at(event.type);
    for (const FieldDeclaration& field : declaration.fields) {
      const auto value = event.params.find(field.key);
      if (value == event.params.end()) continue;
      if (field.kind == FieldKind::utc) count_time(std::get<Instant>(value->second));
      if (field.kind == FieldKind::duration) sum_s += std::get<double>(value->second);
    }
    const PlanRover* rover = rover_of(plan, event.rover_id);
    if (!declaration.drives || rover == nullptr || !rovers.contains(rover->model())) continue;
    const double length_m = drawn_m(*plan.mission.planet, event.geometry, at[event.rover_id]);
    sum_s += detour_factor * length_m / speed_mps(event, rovers.at(rover->model()).spec.vehicle);
  }
  const double hours = std::ceil((latest_s + sum_s + day_s) / hour_s - 1e-9);
  return std::min(from_seconds(hours * hour_s), longest_mission);
}

}  // namespace lsos
