#include "mission/events/event_warnings.h"

#include <fmt/format.h>

#include "planet/body.h"

namespace lsos {

namespace {

// A stationary event whose Point is farther from the rover than this gets a warning.
constexpr double far_from_point_m = 50;
constexpr double late_s = 1;

}  // namespace

std::optional<std::string> unfinished_drive_warning(const PlanEvent& event,
                                                    const RoverAgent& agent) {
  const DriveState drive = agent.drive_state();
  if (drive.status != DriveState::Status::driving) return {};
  return fmt::format(
      "{} of {}: ended while its drive had {:.1f} m to go, which is left off; lsos.arrival waits "
      "for it",
      event.label, event.rover_id, drive.remaining_m);
}

// A StartTime alone sets the start; beside StartWhen or StartAfter it is a lower bound.
std::optional<std::string> late_start_warning(const PlanEvent& event, const EventRecord& record,
                                              const Turn& turn) {
  if (!event.start_time || !event.start_when.text.empty() || !event.start_after.empty()) return {};
  const SimTime wanted = *event.start_time - turn.mission.start_time;
  if (wanted <= SimTime{} || seconds(turn.now - wanted) <= late_s) return {};
  const bool had_no_turn = record.ready && *record.ready > wanted;
  return fmt::format("{} of {}: started {:.4g} s after its StartTime{}", event.label,
                     event.rover_id, seconds(turn.now - wanted),
                     had_no_turn ? ", when its turn came" : "");
}

std::optional<std::string> far_start_warning(const PlanEvent& event, const Turn& turn) {
  if (event.geometry.kind != GeometryKind::point) return {};
  const double away_m = surface_distance_m(*turn.mission.planet, turn.agent.motion().place(),
                                           event.geometry.points.front());
  if (away_m <= far_from_point_m) return {};
  return fmt::format("{} of {}: the rover is {:.0f} m from the event's Point", event.label,
                     event.rover_id, away_m);
}

}  // namespace lsos
