#include "mission/ahead/expected_time.h"

#include <algorithm>

namespace lsos {

namespace {

constexpr double usual_speed_mps = 1;

// Length from the expected place of the rover through all points. `at` becomes the last point.
double length_m(const std::vector<Geodetic>& points, const SiteFrame& site, Geodetic& at) {
  double length = 0;
  for (const Geodetic& point : points) {
    length += surface_distance_m(site.body(), at, point);
    at = point;
  }
  return length;
}

}  // namespace

SimTime expected_end(const EventMachine& machine, SimTime begins, Instant mission_start,
                     const SiteFrame& site, Geodetic& at) {
  const PlanEvent& event = machine.event;
  SimTime end = begins;
  if (event.start_time) end = std::max(end, *event.start_time - mission_start);
  double speed_mps = usual_speed_mps;
  for (const FieldDeclaration& field : machine.declaration.fields) {
    const auto found = event.params.find(field.key);
    if (found == event.params.end()) continue;
    const auto* number = std::get_if<double>(&found->second);
    const auto* until = std::get_if<Instant>(&found->second);
    if (field.kind == FieldKind::duration && number != nullptr) end += from_seconds(*number);
    if (until != nullptr) end = std::max(end, *until - mission_start);
    const bool is_speed = field.unit != nullptr && field.unit->kind == "speed";
    if (is_speed && number != nullptr && *number > 0) speed_mps = *number;
  }
  if (!machine.declaration.drives) return end;
  return end + from_seconds(length_m(event.geometry.points, site, at) / speed_mps);
}

}  // namespace lsos
