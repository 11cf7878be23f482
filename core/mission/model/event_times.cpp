#include "mission/model/event_times.h"

#include <algorithm>

#include "plan/field_reader.h"

namespace lsos {

double durations_s(const PlanEvent& event, const EventDeclaration& declaration) {
  double sum_s = 0;
  for (const FieldDeclaration& field : declaration.fields) {
    if (field.kind != FieldKind::duration) continue;
    const double* duration_s = find_value<double>(event.params, field.key);
    sum_s += duration_s == nullptr ? 0 : *duration_s;
  }
  return sum_s;
}

double drive_speed_mps(const PlanEvent& event, const EventDeclaration& declaration,
                       const VehicleConfig& vehicle) {
  const double* requested_mps = find_number(event.params, declaration, NumberRole::drive_speed);
  const bool is_requested = requested_mps != nullptr && *requested_mps > 0;
  return std::min(is_requested ? *requested_mps : vehicle.cruise_speed_mps, vehicle.speed_max_mps);
}

double drawn_m(const PlanGeometry& geometry, const Body& body, std::optional<Geodetic>& at) {
  double length_m = 0;
  for (const Geodetic& point : geometry.points) {
    if (at) length_m += surface_distance_m(body, *at, point);
    at = point;
  }
  return length_m;
}

}  // namespace lsos
