#include "mission/model/mission_span.h"

#include <algorithm>
#include <cmath>

#include "mission/model/event_times.h"
#include "plan/field_reader.h"

namespace lsos {

namespace {

constexpr double hour_s = 3600;
constexpr double detour_factor = 3;  // driven length over drawn length

}  // namespace

SimTime default_max_duration(const Plan& plan, const Declarations& declarations,
                             const std::map<std::string, RoverModel>& rovers,
                             const std::function<bool(const PlanEvent&)>& is_open_ended) {
  double latest_s = 0, sum_s = 0;
  const auto count_time = [&](Instant time) {
    latest_s = std::max(latest_s, seconds(time - plan.mission.start_time));
  };
  std::map<std::string, std::optional<Geodetic>> at;  // key: rover
  for (const PlanRover& rover : plan.rovers) at[rover.id] = rover.start;
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled) continue;
    const bool has_condition = !event.start_when.text.empty() || !event.stop_when.text.empty();
    if (has_condition || is_open_ended(event)) return longest_mission;
    if (event.start_time) count_time(*event.start_time);
    if (event.at) {
      count_time(plan.mission.start_time + *event.at);
      continue;
    }
    const EventDeclaration& declaration = declarations.events.at(event.type);
    for (const FieldDeclaration& field : declaration.fields) {
      if (field.kind != FieldKind::utc) continue;
      if (const auto* time = find_value<Instant>(event.params, field.key)) count_time(*time);
    }
    sum_s += durations_s(event, declaration);
    const PlanRover* rover = rover_of(plan, event.rover_id);
    if (!declaration.drives || rover == nullptr || !rovers.contains(rover->model())) continue;
    const VehicleConfig& vehicle = rovers.at(rover->model()).spec.vehicle;
    const double length_m = drawn_m(event.geometry, *plan.mission.planet, at[event.rover_id]);
    sum_s += detour_factor * length_m / drive_speed_mps(event, declaration, vehicle);
  }
  const double hours = std::ceil((latest_s + sum_s + day_length_s) / hour_s - 1e-9);
  return std::min(from_seconds(hours * hour_s), longest_mission);
}

}  // namespace lsos
