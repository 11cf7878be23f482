// Warnings about events that run otherwise than their plan or script intends.
#include <fmt/format.h>

#include "mission/events/event_sequence.h"

namespace lsos {

void EventSequence::warn_of_unfinished_drive(const RoverAgent& agent) {
  const DriveState drive = agent.drive();
  if (drive.status != DriveState::Status::driving) return;
  warnings_.push_back(fmt::format(
      "{} of {}: ended while its drive had {:.1f} m to go, which is left off; lsos.arrival waits "
      "for it",
      event().label, event().rover_id, drive.remaining_m));
}

// A StartTime alone sets the start; beside StartWhen or StartAfter it is a lower bound.
void EventSequence::warn_of_late_start(SimTime now) {
  constexpr double late_s = 1;
  if (!event().start_time || !event().start_when.text.empty() || !event().start_after.empty()) {
    return;
  }
  const SimTime wanted = *event().start_time - mission_.start_time;
  if (wanted <= SimTime{} || seconds(now - wanted) <= late_s) return;
  const bool had_no_turn = current().ready && *current().ready > wanted;
  warnings_.push_back(fmt::format("{} of {}: started {:.4g} s after its StartTime{}", event().label,
                                  event().rover_id, seconds(now - wanted),
                                  had_no_turn ? ", when its turn came" : ""));
}

}  // namespace lsos
