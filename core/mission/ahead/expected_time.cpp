#include "mission/ahead/expected_time.h"

#include <algorithm>

#include "mission/model/event_times.h"
#include "plan/field_reader.h"

namespace lsos {

SimTime expected_end(const EventMachine& machine, const VehicleConfig& vehicle, SimTime begins,
                     Instant mission_start, const Body& body, Geodetic& at) {
  const PlanEvent& event = machine.event;
  const EventDeclaration& declaration = machine.declaration;
  SimTime end = begins;
  if (event.start_time) end = std::max(end, *event.start_time - mission_start);
  end += from_seconds(durations_s(event, declaration));
  for (const FieldDeclaration& field : declaration.fields) {
    if (field.kind != FieldKind::utc) continue;
    const auto* until = find_value<Instant>(event.params, field.key);
    if (until != nullptr) end = std::max(end, *until - mission_start);
  }
  if (!declaration.drives) return end;
  std::optional<Geodetic> place = at;
  const double length_m = drawn_m(event.geometry, body, place);
  at = *place;
  return end + from_seconds(length_m / drive_speed_mps(event, declaration, vehicle));
}

}  // namespace lsos
